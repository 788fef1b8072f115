// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/string_blow.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/contact/contact_law.h"
#include "core/model/scales.h"
#include "core/model/section_field.h"
#include "core/model/section_pieces.h"
#include "core/model/section_words.h"
#include "core/wave/problem.h"

namespace drillwave {

std::vector<SectionStress> sectionStresses(const Scenario& scenario, const Impact& impact) {
    const std::vector<SectionForces>& forces = impact.sections;
    if (forces.empty()) return {};
    const Scales scales = scalesOf(scenario);
    const std::vector<const Section*> sections = allSections(scenario.drillString);
    assert(sections.size() == forces.size());
    std::vector<SectionStress> stresses;
    for (std::size_t j = 0; j < sections.size(); ++j) {
        const auto inSi = [&](const SectionPeak& peak) {
            return StressPeak{peak.force * (scales.force / areaAt(*sections[j], peak.place)),
                              peak.place * sections[j]->length, peak.time * scales.time};
        };
        stresses.push_back(eachOf(forces[j], inSi));
    }
    return stresses;
}

std::vector<SectionStress> sectionStresses(const Scenario& scenario, const RodForces& forces) {
    const Scales scales = scalesOf(scenario);
    const auto inSi = [&](const RodForce& force) {
        return StressPeak{force.size * scales.stress, force.section * scenario.rod.length,
                          force.time * scales.time};
    };
    return {eachOf(forces, inSi)};
}

StringPeak largestStress(const std::vector<SectionStress>& stresses, Load load) {
    const auto size = [&](const SectionStress& section) { return section[load].stress; };
    const auto found = std::ranges::max_element(stresses, {}, size);
    return {static_cast<std::size_t>(found - stresses.begin()), (*found)[load]};
}

namespace {

/// Returns the largest change of the cross-section within a piece of a cone, as a share of the smaller one:
/// the stress at its thin end may be above that of the piece by as much.
double changeInPiece(const Section& section, int count) {
    const double share = 1.0 / count;
    double largest = 0;
    for (const double end : {0.0, 1.0 - share}) {
        const double one = areaAt(section, end), other = areaAt(section, end + share);
        largest = std::max(largest, std::max(one, other) / std::min(one, other) - 1);
    }
    return largest;
}

/// Returns the error that pieces of cones may make in the largest stresses, as a share of them.
double stressErrorOfPieces(const Scenario& scenario, const std::vector<SectionStress>& stresses,
                           const std::vector<int>& pieces) {
    if (pieces.empty()) return 0;
    const std::vector<const Section*> sections = allSections(scenario.drillString);
    // Steps between pieces reflect a front as a staircase, each half a step above or below the slope.
    constexpr double shareElsewhere = 0.5;
    double error = 0;
    for (std::size_t j = 0; j < sections.size(); ++j)
        if (pieces[j] > 1) error = std::max(error, shareElsewhere * changeInPiece(*sections[j], pieces[j]));
    for (const Load load : loads) {
        const double known = largestStress(stresses, load).peak.stress;
        for (std::size_t j = 0; j < sections.size() && known > 0; ++j)
            if (pieces[j] > 1)
                error = std::max(
                    error,
                    stresses[j][load].stress * (1 + changeInPiece(*sections[j], pieces[j])) / known - 1);
    }
    return error;
}

}  // namespace

void addStresses(ImpactSummary& summary, const Scenario& scenario, const Impact& impact,
                 const std::vector<int>& pieces) {
    const std::vector<SectionStress> stresses = sectionStresses(scenario, impact);
    if (stresses.empty()) return;
    const double unit = scalesOf(scenario).stress;
    for (const Load load : loads)
        if (!isAfter(load) || hasStressesAfter(impact))
            summary.largest[load] = largestStress(stresses, load).peak.stress / unit;
    summary.stressError = impact.forcesError + stressErrorOfPieces(scenario, stresses, pieces);
}

bool hasStressesAfter(const Impact& impact) {
    return !impact.sections.empty() && impact.endOfBlow < impact.forcesEnd;
}

namespace {

/// The key of a strength of a section.
std::string strengthKey(const DrillString& drill, std::size_t j, std::string_view field) {
    if (drill.parts.empty()) return "rod." + std::string(field);
    const std::size_t ofHammer = drill.hammer.sections.size();
    return j < ofHammer ? sectionKey(SectionAddress::Chain::hammer, j + 1, field)
                        : sectionKey(SectionAddress::Chain::string, j - ofHammer + 1, field);
}

}  // namespace

std::vector<Alert> stressAlerts(const Scenario& scenario, const std::vector<SectionStress>& stresses) {
    std::vector<Alert> alerts;
    if (!hasUnits(scenario)) return alerts;
    std::vector<const Section*> sections = allSections(scenario.drillString);
    Section rod;
    rod.yieldStrength = scenario.rod.yieldStrength;
    rod.fatigueStrength = scenario.rod.fatigueStrength;
    if (sections.empty()) sections.push_back(&rod);
    std::vector<const Section*> reported;  // a repeated section is reported once, where it is worst
    for (std::size_t j = 0; j < stresses.size(); ++j) {
        const Section* section = sections[j];
        if (std::ranges::find(reported, section) != reported.end()) continue;
        reported.push_back(section);
        const auto worst = [&](auto measure) {
            std::size_t most = j;
            for (std::size_t i = j; i < stresses.size(); ++i)
                if (sections[i] == section && measure(stresses[i]) > measure(stresses[most])) most = i;
            return most;
        };
        // during the blow, or else of the waves left, which a real string damps: one remark a strength
        const auto add = [&](std::optional<double> limit, AlertCode code, std::string_view field,
                             bool tensionOnly) {
            if (!limit) return;
            for (const bool after : {false, true}) {
                const auto load = [&](const SectionStress& stress) {
                    const StressPeak& pull = after ? stress.tensionAfter : stress.tension;
                    const StressPeak& push = after ? stress.compressionAfter : stress.compression;
                    const bool pulled = tensionOnly || pull.stress > push.stress;
                    return std::pair(pulled ? "tension" : "compression", pulled ? pull : push);
                };
                const std::size_t at =
                    worst([&](const SectionStress& stress) { return load(stress).second.stress; });
                const auto [kind, peak] = load(stresses[at]);
                if (peak.stress <= *limit) continue;
                alerts.push_back({after ? AlertLevel::information : AlertLevel::warning,
                                  code,
                                  strengthKey(scenario.drillString, at, field),
                                  {{kind, peak.stress, Quantity::stress},
                                   {"place", peak.place, Quantity::length},
                                   {"time", peak.time, Quantity::time},
                                   {"strength", *limit, Quantity::stress}}});
                if (section == &rod) return;
                alerts.back().arguments.push_back({"section", static_cast<double>(at + 1)});
                alerts.back().subject = sectionWords(scenario.drillString)[at];
                return;
            }
        };
        add(section->yieldStrength, AlertCode::stressAboveYield, "yield_strength", false);
        add(section->fatigueStrength, AlertCode::stressAboveFatigue, "fatigue_strength", true);
    }
    return alerts;
}

std::vector<Alert> stringAlerts(const Scenario& scenario, const Impact& impact) {
    std::vector<Alert> alerts;
    const Scales scales = scalesOf(scenario);
    if (impact.isRounded()) {
        Alert alert{AlertLevel::warning,
                    AlertCode::lengthsRounded,
                    "",
                    {{"time", impact.rounding * scales.time, Quantity::time}}};
        if (scenario.bitRock.gamma < 1)
            alert.arguments.push_back({"efficiency_error", impact.efficiencyError});
        else  // elastic rock keeps nothing, whatever the lengths are
            alert.arguments.push_back({"cor_error", impact.corError});
        if (impact.sharedCell > 0)
            alert.arguments.push_back({"shared_cell", impact.sharedCell * scales.time, Quantity::time});
        alerts.push_back(alert);
    }
    if (impact.wavesDifference)
        alerts.push_back({AlertLevel::information,
                          AlertCode::wavesThinned,
                          "",
                          {{"difference", *impact.wavesDifference}}});
    if (impact.outcome == Outcome::nextBlow) {
        alerts.push_back({AlertLevel::warning,
                          AlertCode::blowNotOver,
                          "",
                          {{"time", impact.endTime * scales.time, Quantity::time}}});
        if (isForced(scenario)) alerts.back().arguments.push_back({"forced", 1});
    }
    if (impact.leftOutForces) alerts.push_back({AlertLevel::warning, AlertCode::stressesLeftOut, "", {}});
    return alerts;
}

std::optional<StrengthUse> strengthUse(const SectionStress& stress,
                                       const std::optional<double>& yieldStrength,
                                       const std::optional<double>& fatigueStrength) {
    using enum StrengthUse::Strength;
    std::optional<StrengthUse> most;
    const auto take = [&most](const StrengthUse& use) {
        if (!most || use.share() > most->share()) most = use;
    };
    if (fatigueStrength) take({fatigue, true, stress.tension, *fatigueStrength});
    if (yieldStrength) {
        const bool isTension = stress.tension.stress > stress.compression.stress;
        take({yield, isTension, isTension ? stress.tension : stress.compression, *yieldStrength});
    }
    return most;
}

std::vector<std::optional<StrengthUse>> strengthUses(const Scenario& scenario,
                                                     const std::vector<SectionStress>& stresses) {
    const std::vector<const Section*> sections = allSections(scenario.drillString);
    std::vector<std::optional<StrengthUse>> uses;
    if (sections.empty()) {
        for (const SectionStress& stress : stresses)
            uses.push_back(strengthUse(stress, scenario.rod.yieldStrength, scenario.rod.fatigueStrength));
        return uses;
    }
    assert(stresses.empty() || stresses.size() == sections.size());
    for (std::size_t j = 0; j < stresses.size(); ++j)
        uses.push_back(strengthUse(stresses[j], sections[j]->yieldStrength, sections[j]->fatigueStrength));
    return uses;
}

std::optional<std::size_t> mostUsedSection(const std::vector<std::optional<StrengthUse>>& uses) {
    std::optional<std::size_t> most;
    for (std::size_t j = 0; j < uses.size(); ++j)
        if (uses[j] && (!most || uses[j]->share() > uses[*most]->share())) most = j;
    return most;
}

}  // namespace drillwave
