// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/section_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/blow/outputs.h"

namespace drillwave {

namespace {

std::string percent(double share, const ReadingStyle& style) {
    return style.number(100 * (std::abs(share) < 1e-12 ? 0 : share), 4) + " %";
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

TextGrid energyGrid(const Blow& blow, const ReadingStyle& style) {
    struct Line {
        const char *output, *label;
        bool whereAny = false;  ///< only where there is some of it
    };
    constexpr Line lines[] = {{"rock_work", "  in the rock"},
                              {"hammer_rebound_energy", "  hammer moving back"},
                              {"hammer_wave_energy", "  waves in the hammer"},
                              {"rebound_energy", "  string moving back"},
                              {"residual_wave_energy", "  waves in the string"},
                              {"joint_loss", "  lost in joints", true},
                              {"rod_loss", "  lost in sections", true},
                              {"face_energy", "  between the faces", true}};
    const ImpactSummary& summary = blow.summary;
    TextGrid grid(CellAlignment::left);
    const double unit = blow.drivenEnergy() * blow.scales.energy;
    const auto add = [&](const char* label, double share) {
        grid.add({label, percent(share, style), style.quantity(share * unit, Quantity::energy, 4)});
    };
    add(isForced(blow.scenario) ? "work of the force" : "energy of the hammer", 1);
    for (const Line& line : lines) {
        const std::optional<double> share = findOutput(line.output)->value({summary, blow.scenario});
        if (share && (!line.whereAny || *share > 0)) add(line.label, *share);
    }
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

TextGrid sectionGrid(const Blow& blow, const ReadingStyle& style) {
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

}  // namespace drillwave
