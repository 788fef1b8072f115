// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/string_blow.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/contact/bilinear_law.h"
#include "core/model/scales.h"
#include "core/model/section_parameter.h"
#include "core/wave/problem.h"

namespace drillwave {

StringBlow solveString(const Scenario& scenario, const NetworkSettings& settings, NetworkSolver& solver,
                       const std::stop_token& stop) {
    StringBlow blow{problemOf(scenario), {}};
    blow.impact = solver.solve(blow.problem, settings, stop);
    return blow;
}

Impact impactOf(const StringBlow& blow) {
    const NetworkImpact& from = blow.impact;
    Impact impact;
    impact.pieces = from.cells;
    if (from.end == NetworkEnd::notSolved) {
        impact.reason = from.reason;
        impact.hindrance = from.hindrance;
        return impact;
    }
    impact.outcome = Outcome::rebounded;
    const double p0 = from.hammerMomentum;
    impact.impulse = from.rockImpulse / p0;
    impact.cor = from.faceImpulse > 0 ? -from.stringMomentum / from.faceImpulse : 0;
    impact.corError = from.corError;
    impact.peakForce = from.peakForce;
    const double never = std::numeric_limits<double>::quiet_NaN();
    impact.firstContactTime = from.firstContact >= 0 ? from.firstContact : never;
    impact.separationTime = from.lastSeparation >= 0 ? from.lastSeparation : never;
    impact.contactDuration = from.contactDuration;
    impact.contacts = from.contacts;
    impact.events = from.events;
    if (from.waves) {
        impact.incident = from.waves->bitWave();
        impact.force = from.waves->bitForce();
    }
    return impact;
}

ImpactSummary summarize(const Scenario& scenario, const StringBlow& blow) {
    const NetworkImpact& from = blow.impact;
    const Impact impact = impactOf(blow);
    ImpactSummary summary;
    summary.cor = impact.cor;
    summary.impulse = impact.impulse;
    summary.peakForce = impact.peakForce;
    summary.maxPenetration = from.largestPenetration * lawUnitOfPenetration;
    summary.residualPenetration = from.residualPenetration * lawUnitOfPenetration;
    summary.firstContactTime = impact.firstContactTime;
    summary.separationTime = impact.separationTime;
    summary.contactDuration = impact.contactDuration;
    summary.corError = impact.corError;
    summary.contacts = impact.contacts;
    summary.momentumResidual = from.momentumResidual;
    const double stringMass = blow.problem.mass();
    summary.workRatio = blow.problem.isForced() ? from.hammerEnergy * 2 * stringMass  // [paper (2)]
                                                : 1 - from.energy.hammer - from.energy.face;
    const double rebound = from.stringMomentum * from.stringMomentum / (2 * stringMass) / from.hammerEnergy;
    summary.energy = {from.energy.rock, rebound, from.energy.string - rebound, from.energyResidual};

    StringSummary string;
    string.end = from.end;
    string.endTime = from.endTime;
    string.efficiency = from.energy.rock;
    string.efficiencyError = from.efficiencyError;
    if (!blow.problem.isForced()) {
        const double back = -from.pistonMomentum / from.hammerMass;
        string.hammerReboundVelocity = back / blow.problem.velocity();
        string.hammerReboundEnergy = from.hammerMass * back * back / 2 / from.hammerEnergy;
        string.hammerWaveEnergy = from.energy.hammer - string.hammerReboundEnergy;
    }
    string.efficiencyRecovered = from.energy.rock + string.hammerReboundEnergy;
    string.stringMomentum = from.stringMomentum / from.hammerMomentum;
    string.stringEnergy = from.energy.string;
    string.jointLoss = from.energy.joints;
    string.rodLoss = from.energy.rods;
    string.faceImpulse = from.faceImpulse / from.hammerMomentum;
    string.faceEnergy = from.energy.face;
    string.pistonSeparationTime =
        from.faceSeparation >= 0 ? from.faceSeparation : std::numeric_limits<double>::quiet_NaN();
    if (const auto stresses = sectionStresses(scenario, blow); !stresses.empty()) {
        const double unit = scalesOf(scenario).stress;
        const auto largest = [&](RodForce RodForces::*which) {
            return largestStress(stresses, which).peak.stress / unit;
        };
        string.largestCompression = largest(&RodForces::compression);
        string.largestTension = largest(&RodForces::tension);
        if (hasStressesAfter(from)) {
            string.largestCompressionAfter = largest(&RodForces::compressionAfter);
            string.largestTensionAfter = largest(&RodForces::tensionAfter);
        }
    }
    summary.string = string;
    return summary;
}

std::vector<SectionStress> sectionStresses(const Scenario& scenario, const StringBlow& blow) {
    const std::vector<SectionForces>& forces = blow.impact.sections;
    if (forces.empty()) return {};
    const DrillString& drill = scenario.drillString;
    const Scales scales = scalesOf(scenario);
    const std::vector<const Section*> sections = allSections(drill);
    assert(sections.size() == forces.size());
    std::vector<SectionStress> stresses;
    for (std::size_t j = 0; j < sections.size(); ++j) {
        const double toStress = scales.force / propertiesOf(*sections[j], drill.material).area;
        const auto inSi = [&](const SectionPeak& peak) {
            return StressPeak{peak.force * toStress, peak.place * sections[j]->length,
                              peak.time * scales.time};
        };
        stresses.push_back({inSi(forces[j].compression), inSi(forces[j].tension),
                            inSi(forces[j].compressionAfter), inSi(forces[j].tensionAfter)});
    }
    return stresses;
}

StringPeak largestStress(const std::vector<SectionStress>& stresses, RodForce RodForces::*which) {
    constexpr std::pair<RodForce RodForces::*, StressPeak SectionStress::*> names[] = {
        {&RodForces::compression, &SectionStress::compression},
        {&RodForces::tension, &SectionStress::tension},
        {&RodForces::compressionAfter, &SectionStress::compressionAfter},
        {&RodForces::tensionAfter, &SectionStress::tensionAfter}};
    const auto name = std::ranges::find_if(names, [&](const auto& each) { return each.first == which; });
    const auto size = [&](const SectionStress& section) { return (section.*name->second).stress; };
    const auto found = std::ranges::max_element(stresses, {}, size);
    return {static_cast<std::size_t>(found - stresses.begin()), *found.*name->second};
}

bool hasStressesAfter(const NetworkImpact& impact) {
    return !impact.sections.empty() && impact.endOfBlow < impact.forcesEnd;
}

namespace {

/// The key of a strength of a section, for which a parameter is kept for ever.
std::string_view strengthKey(const DrillString& drill, std::size_t j, std::string_view field) {
    const std::size_t ofHammer = drill.hammer.sections.size();
    const std::string key = j < ofHammer
                                ? "hammer." + std::to_string(j + 1) + "." + std::string(field)
                                : "string." + std::to_string(j - ofHammer + 1) + "." + std::string(field);
    const Parameter* parameter = findParameter(key);
    return parameter ? parameter->key : std::string_view();
}

void addOverloads(const Scenario& scenario, const StringBlow& blow, std::vector<Alert>& alerts) {
    const std::vector<SectionStress> stresses = sectionStresses(scenario, blow);
    const std::vector<const Section*> sections = allSections(scenario.drillString);
    std::vector<const Section*> told;  // a section that is repeated is told of where it is worst
    for (std::size_t j = 0; j < stresses.size(); ++j) {
        const Section* section = sections[j];
        if (std::ranges::find(told, section) != told.end()) continue;
        told.push_back(section);
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
                                   {"strength", *limit, Quantity::stress},
                                   {"section", static_cast<double>(at + 1)}}});
                return;
            }
        };
        add(section->yieldStrength, AlertCode::stressAboveYield, "yield_strength", false);
        add(section->fatigueStrength, AlertCode::stressAboveFatigue, "fatigue_strength", true);
    }
}

}  // namespace

std::vector<Alert> stringAlerts(const Scenario& scenario, const StringBlow& blow) {
    std::vector<Alert> alerts;
    addOverloads(scenario, blow, alerts);
    const Scales scales = scalesOf(scenario);
    // what a shared cell leaves is below what lengths are given to
    constexpr double noticedRounding = 1e-7;
    if (blow.impact.rounding > noticedRounding) {
        Alert alert{AlertLevel::warning,
                    AlertCode::lengthsRounded,
                    "",
                    {{"time", blow.impact.rounding * scales.time, Quantity::time}}};
        if (blow.problem.law.gamma < 1)
            alert.arguments.push_back({"efficiency_error", blow.impact.efficiencyError});
        else  // elastic rock keeps nothing, whatever the lengths are
            alert.arguments.push_back({"cor_error", blow.impact.corError});
        if (blow.impact.sharedCell > 0)
            alert.arguments.push_back({"shared_cell", blow.impact.sharedCell * scales.time, Quantity::time});
        alerts.push_back(alert);
    }
    if (blow.impact.end == NetworkEnd::nextBlow)
        alerts.push_back({AlertLevel::warning,
                          AlertCode::blowNotOver,
                          "",
                          {{"time", blow.impact.endTime * scales.time, Quantity::time}}});
    if (blow.impact.leftOutForces)
        alerts.push_back({AlertLevel::warning, AlertCode::stressesLeftOut, "", {}});
    return alerts;
}

}  // namespace drillwave
