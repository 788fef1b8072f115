// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/section_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/blow/outputs.h"
#include "core/model/section_words.h"

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
    return style.said({translatable("%1 at %2, %3"),
                       {style.quantity(peak.stress, Quantity::stress, 4), placeCell(peak.place, style),
                        style.quantity(peak.time, Quantity::time, 4)}});
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
    constexpr Line lines[] = {{"rock_work", translatable("in the rock")},
                              {"hammer_rebound_energy", translatable("hammer moving back")},
                              {"hammer_wave_energy", translatable("waves in the hammer")},
                              {"rebound_energy", translatable("string moving back")},
                              {"residual_wave_energy", translatable("waves in the string")},
                              {"joint_loss", translatable("lost in joints"), true},
                              {"rod_loss", translatable("lost in sections"), true},
                              {"face_energy", translatable("between the faces"), true}};
    const ImpactSummary& summary = blow.summary;
    TextGrid grid(CellAlignment::left);
    // The three shares of a uniform rod are lines of its summary.
    if (!findOutput("joint_loss")->value({summary, blow.scenario})) return grid;
    const double unit = blow.drivenEnergy() * blow.scales.energy;
    const auto add = [&](const std::string& label, double share) {
        grid.add({label, percent(share, style), style.quantity(share * unit, Quantity::energy, 4)});
    };
    add(style.said(isForced(blow.scenario) ? translatable("work of the force")
                                           : translatable("energy of the hammer")),
        1);
    for (const Line& line : lines) {
        const std::optional<double> share = findOutput(line.output)->value({summary, blow.scenario});
        if (share && (!line.whereAny || *share > 0)) add("  " + style.said(line.label), *share);
    }
    grid.add({style.said(translatable("balance errors")),
              style.said(
                  {translatable("%1 of the momentum, %2 of the energy"),
                   {style.number(summary.momentumResidual, 2), style.number(summary.energy.residual, 2)}})});
    return grid;
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
    std::vector<const char*> titles{translatable("section"), translatable("compression"),
                                    translatable("tension")};
    if (hasAfter) titles.push_back(translatable("tension after"));
    if (hasYield) titles.push_back(translatable("of yield"));
    if (hasFatigue) titles.push_back(translatable("of fatigue"));
    titles.push_back(translatable("joint reflects"));
    grid.addTitles(titles, style);
    const std::size_t ofHammer = drill.hammer.sections.size();
    const std::vector<Message> words = sectionWords(drill);
    // "7: 3rd rod", the number being that of the keys.
    const auto sectionCell = [&](std::size_t j) {
        const bool hasNumber = j < ofHammer || sections[j]->name.empty();
        return (hasNumber ? std::string() : std::to_string(j - ofHammer + 1) + ": ") + style.said(words[j]);
    };
    for (std::size_t j = 0; j < sections.size(); ++j) {
        const SectionStress& stress = stresses[j];
        std::vector<std::string> cells{sectionCell(j), stressCell(stress.compression, style),
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
