// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/string_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/model/scales.h"
#include "core/report/feed_words.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

std::string si(double value, Quantity quantity, int digits = 5) {
    return inHandyUnit(value, quantity, digits);
}

std::string percent(double share, const ReadingStyle& style) {
    return style.number(100 * (std::abs(share) < 1e-12 ? 0 : share), 4) + " %";
}

/// Numbers with what they are in SI.
std::string resultGrid(const Blow& blow) {
    const ImpactSummary& summary = blow.summary;
    const Scales& scales = blow.scales;
    TextGrid grid(CellAlignment::left);
    grid.add({"efficiency", rounded(summary.energy.rockWork, 12) + "  (error below " +
                                boundText(summary.efficiencyError) + ")"});
    const bool forced = isForced(blow.scenario);
    if (!forced) grid.add({"  and what the hammer takes back", rounded(summary.efficiencyRecovered())});
    grid.add({"work on the rock",
              si(summary.energy.rockWork * blow.drivenEnergy() * scales.energy, Quantity::energy)});
    grid.add({"impulse on the rock", si(summary.impulse * scales.impulse, Quantity::impulse),
              rounded(summary.impulse) + (forced ? " of the force's" : " of the hammer's")});
    grid.add({"restitution e of the string", rounded(summary.cor)});
    grid.add({"peak force on the rock", si(summary.peakForce * scales.force, Quantity::force)});
    grid.add({"largest penetration", si(summary.maxPenetration * scales.penetration, Quantity::length)});
    grid.add(
        {"penetration that stays", si(summary.residualPenetration * scales.penetration, Quantity::length)});
    if (summary.contacts > 0) {
        grid.add({"first contact", si(summary.firstContactTime * scales.time, Quantity::time)});
        if (!std::isnan(summary.separationTime))
            grid.add({"last separation", si(summary.separationTime * scales.time, Quantity::time)});
        grid.add({"time in contact", si(summary.contactDuration * scales.time, Quantity::time)});
    }
    if (!forced && !std::isnan(summary.faceSeparationTime))
        grid.add({"hammer leaves", si(summary.faceSeparationTime * scales.time, Quantity::time)});
    if (!forced)
        grid.add({"hammer rebound", si(summary.hammerReboundVelocity * scales.velocity, Quantity::velocity),
                  "away from the rock"});
    if (blow.feed) {
        std::string needed = si(blow.feed->fullRate, Quantity::force);
        const std::optional<FeedForce>& force = blow.feed->force;
        if (force) needed += ", installed " + si(force->thrust, Quantity::force);
        if (force && force->weight) needed += ", effective " + si(force->effective(), Quantity::force);
        grid.add({"thrust needed", needed});
        if (force) grid.add({"  feed", std::string(feedWord(blow.feed->feed))});
    }
    return grid.text();
}

/// Zero in the unit of small lengths.
std::string placeCell(double place, const ReadingStyle& style) {
    constexpr double millimetre = 1e-3;
    return place == 0 ? style.number(0) + " " + style.unitFor(millimetre, Quantity::length).name
                      : style.quantity(place, Quantity::length, 3);
}

std::string stressCell(const StressPeak& peak, const ReadingStyle& style) {
    if (peak.stress == 0) return style.number(0);
    return style.quantity(peak.stress, Quantity::stress, 4) + " at " + placeCell(peak.place, style) + ", " +
           style.quantity(peak.time, Quantity::time, 4);
}

std::string shareOf(double stress, const std::optional<double>& strength, const ReadingStyle& style) {
    return strength ? style.number(100 * stress / *strength, 3) + " %" : std::string();
}

}  // namespace

TextGrid stringEnergyGrid(const Blow& blow, const ReadingStyle& style) {
    const ImpactSummary& summary = blow.summary;
    TextGrid grid(CellAlignment::left);
    const double unit = blow.drivenEnergy() * blow.scales.energy;
    const auto add = [&](const char* label, double share) {
        grid.add({label, percent(share, style), style.quantity(share * unit, Quantity::energy, 4)});
    };
    const bool forced = isForced(blow.scenario);
    add(forced ? "work of the force" : "energy of the hammer", 1);
    add("  in the rock", summary.energy.rockWork);
    if (!forced) {
        add("  hammer moving back", summary.hammerReboundEnergy);
        add("  waves in the hammer", summary.hammerWaveEnergy);
    }
    add("  string moving back", summary.energy.reboundEnergy);
    add("  waves in the string", summary.energy.residualWaveEnergy);
    if (summary.jointLoss > 0) add("  lost in joints", summary.jointLoss);
    if (summary.rodLoss > 0) add("  lost in sections", summary.rodLoss);
    if (summary.faceEnergy > 0) add("  between the faces", summary.faceEnergy);
    grid.add({"balance errors", style.number(summary.momentumResidual, 2) + " of the momentum, " +
                                    style.number(summary.energy.residual, 2) + " of the energy"});
    return grid;
}

std::string sectionLabel(const DrillString& drillString, std::size_t section) {
    const std::size_t ofHammer = drillString.hammer.sections.size();
    const bool isHammer = section < ofHammer;
    const std::string number = std::to_string(isHammer ? section + 1 : section + 1 - ofHammer);
    const std::string& name = allSections(drillString)[section]->name;
    return (isHammer ? "hammer " : "") + number + (name.empty() ? "" : " " + name);
}

TextGrid stringSectionGrid(const Blow& blow, const ReadingStyle& style) {
    const DrillString& drill = blow.scenario.drillString;
    const std::vector<const Section*> sections = allSections(drill);
    const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
    const std::vector<double>& reflected = blow.impact.jointReflection;
    const bool hasYield =
        std::ranges::any_of(sections, [](const Section* s) { return s->yieldStrength.has_value(); });
    const bool hasFatigue =
        std::ranges::any_of(sections, [](const Section* s) { return s->fatigueStrength.has_value(); });
    TextGrid grid(CellAlignment::left);
    const bool hasAfter = hasStressesAfter(blow.impact);
    std::vector<std::string> titles{"section", "compression", "tension"};
    if (hasAfter) titles.emplace_back("tension after");
    if (hasYield) titles.emplace_back("of yield");
    if (hasFatigue) titles.emplace_back("of fatigue");
    titles.emplace_back("joint reflects");
    grid.add(titles);
    const std::size_t ofHammer = drill.hammer.sections.size();
    for (std::size_t j = 0; j < sections.size(); ++j) {
        const SectionStress& stress = stresses[j];
        std::vector<std::string> cells{sectionLabel(drill, j), stressCell(stress.compression, style),
                                       stressCell(stress.tension, style)};
        if (hasAfter) cells.push_back(stressCell(stress.tensionAfter, style));
        const double largest = std::max(stress.compression.stress, stress.tension.stress);
        if (hasYield) cells.push_back(shareOf(largest, sections[j]->yieldStrength, style));
        if (hasFatigue) cells.push_back(shareOf(stress.tension.stress, sections[j]->fatigueStrength, style));
        if (j >= ofHammer && j - ofHammer < reflected.size())
            cells.push_back(percent(reflected[j - ofHammer], style));
        grid.add(std::move(cells));
    }
    return grid;
}

std::string stringResultText(const Blow& blow) {
    std::string text = resultGrid(blow) + "\n" + stringEnergyGrid(blow).text();
    // a thousand lines are for a file
    constexpr std::size_t mostLines = 60;
    if (!blow.impact.sections.empty() && blow.impact.sections.size() <= mostLines)
        text += "\n" + stringSectionGrid(blow).text();
    return text;
}

}  // namespace drillwave
