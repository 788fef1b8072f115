// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_text.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "core/blow/outputs.h"
#include "core/blow/solver_words.h"
#include "core/model/blow_traits.h"
#include "core/report/alert_words.h"
#include "core/report/feed_words.h"
#include "core/report/report_numbers.h"
#include "core/report/report_text.h"
#include "core/report/section_grid.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

/// A line of the summary: an output under the words of the summary.
struct SummaryLine {
    std::string_view output;
    std::string_view label;
    OutputOf of = OutputOf::anyBlow;
    std::string_view remark = {};  ///< behind the number; of multiples what they are of
    bool afterContact = false;     ///< only where bit and rock have met
};

/// Of uniform rods as multiples and in SI, of drill strings in SI alone; what comes before and behind them is
/// added by hand.
constexpr auto summaryLines = std::to_array<SummaryLine>({
    {"efficiency_recovered", "  and what the hammer takes back", OutputOf::hammer},
    {"rock_work", "work on the rock", OutputOf::drillString},
    {"impulse", "impulse 1 + e", OutputOf::uniformRod},
    {"impulse", "impulse on the rock", OutputOf::drillString, "of the hammer's"},
    {"cor", "restitution e of the string", OutputOf::drillString},
    {"peak_force", "peak force", OutputOf::uniformRod},
    {"peak_force", "peak force on the rock", OutputOf::drillString},
    {"max_penetration", "largest penetration"},
    {"residual_penetration", "residual penetration", OutputOf::uniformRod},
    {"residual_penetration", "penetration that stays", OutputOf::drillString},
    {"peak_compression", "largest compression", OutputOf::uniformRod},
    {"peak_tension", "largest tension", OutputOf::uniformRod},
    {"peak_compression_after", "  compression after", OutputOf::uniformRod},
    {"peak_tension_after", "  tension after", OutputOf::uniformRod},
    {"percussion_power", "percussion power", OutputOf::uniformRod},
    {"penetration_rate", "penetration rate", OutputOf::uniformRod, "at most "},
    {"first_contact_time", "first contact", OutputOf::anyBlow, "", true},
    {"separation_time", "last separation", OutputOf::anyBlow, "", true},
    {"contact_duration", "time in contact", OutputOf::anyBlow, "", true},
    {"piston_separation_time", "hammer leaves", OutputOf::hammer},
    {"hammer_rebound_velocity", "hammer rebound", OutputOf::hammer, "away from the rock"},
    {"work_ratio", "hammer work W", OutputOf::uniformRod},
    {"rock_work", "  in the rock", OutputOf::uniformRod},
    {"rebound_energy", "  in the rebound", OutputOf::uniformRod},
    {"residual_wave_energy", "  in waves", OutputOf::uniformRod},
});

int digitsOf(const Blow& blow) {
    return hasSections(blow.scenario) ? 5 : 6;
}

/// As a multiple, in SI, and of a largest stress where and when.
std::vector<std::string> cellsOfRod(const SummaryLine& line, const Output& output, double value,
                                    const Blow& blow) {
    std::vector<std::string> cells{std::string(line.label)};
    if (output.isOnlySi()) {
        cells.push_back(std::string(line.remark) + inHandyUnit(value, output.quantity(), 4));
        return cells;
    }
    cells.push_back(rounded(value) + " " + std::string(multipleName(output.measure, blow.scenario)));
    if (hasUnits(blow.scenario)) cells.push_back(siText(output, value, blow, plainStyle(), digitsOf(blow)));
    if (output.load && value > 0) cells.push_back(placeText((*blow.summary.rodForces)[*output.load], blow));
    return cells;
}

/// In SI where there is a unit; empty where there is no such time.
std::vector<std::string> cellsOfString(const SummaryLine& line, const Output& output, double value,
                                       const Blow& blow) {
    if (output.measure == Measure::time && std::isnan(value)) return {};
    const bool isPlain = output.measure == Measure::number || output.measure == Measure::share;
    std::vector<std::string> cells{std::string(line.label),
                                   isPlain ? rounded(value) : siText(output, value, blow)};
    const std::string remark(isForced(blow.scenario) && output.measure == Measure::impulse ? "of the force's"
                                                                                           : line.remark);
    if (output.measure == Measure::impulse)
        cells.push_back(rounded(value) + " " + remark);
    else if (!remark.empty())
        cells.push_back(remark);
    return cells;
}

void addSummary(TextGrid& grid, const Blow& blow) {
    for (const SummaryLine& line : summaryLines) {
        if (!concerns(line.of, blow.scenario)) continue;
        const Output& output = *findOutput(line.output);
        if (!output.problem(blow.scenario).empty()) continue;
        const std::optional<double> value = output.value({blow.summary, blow.scenario});
        if (!value) continue;
        if (!hasSections(blow.scenario))
            grid.add(cellsOfRod(line, output, shareOrZero(output, *value), blow));
        else if (!line.afterContact || blow.summary.contacts > 0)
            if (std::vector<std::string> cells = cellsOfString(line, output, *value, blow); !cells.empty())
                grid.add(std::move(cells));
    }
}

/// Of the margin over the largest of the four needs.
std::string marginText(double margin, double effective) {
    const double need = effective / (1 + margin);
    const std::string share = rounded(100 * std::abs(margin), 3) + " %";
    return inHandyUnit(need, Quantity::force, 4) +
           (margin < 0 ? ", not met: short by " + inHandyUnit(need - effective, Quantity::force, 4) + " (" +
                             share + ")"
                       : ", met with " + inHandyUnit(effective - need, Quantity::force, 4) + " (" + share +
                             ") to spare");
}

void addFeed(TextGrid& grid, const Blow& blow) {
    if (!blow.feed) return;
    const std::optional<FeedForce>& force = blow.feed->force;
    const auto newton = [&](double thrust) { return inHandyUnit(thrust, Quantity::force, digitsOf(blow)); };
    std::string needed = newton(blow.feed->fullRate);
    if (force) needed += ", installed " + newton(force->thrust);
    if (force && force->weight) needed += ", effective " + newton(force->effective());
    grid.add({"thrust needed", needed});
    if (const std::optional<double> margin = blow.thrustMargin())
        grid.add({"  at every gap", marginText(*margin, force->effective())});
    if (force) grid.add({"  feed", std::string(feedWord(blow.feed->feed))});
}

/// What a blow is judged by first, with its error.
std::string mainText(double value, double error, bool isEstimate = false) {
    return rounded(value, 12) + (isEstimate ? "  (error estimated as " : "  (error below ") +
           boundText(error) + ")";
}

std::string resultText(const Blow& blow) {
    const OutputSource numbers{blow.summary, blow.scenario};
    const MainOutput main = mainOutput(blow.scenario);
    TextGrid grid(CellAlignment::left);
    grid.add(
        {std::string(main.value->title), mainText(*main.value->value(numbers), *main.error->value(numbers),
                                                  blow.method.method == Method::lattice)});
    addSummary(grid, blow);
    if (!hasSections(blow.scenario))
        grid.add({"balance errors", rounded(blow.summary.momentumResidual, 2) + " of I0, " +
                                        rounded(blow.summary.energy.residual, 2) + " of W"});
    addFeed(grid, blow);
    std::string text = grid.text();
    if (hasSections(blow.scenario)) text += "\n" + energyGrid(blow).text();
    // a thousand lines are for a file
    constexpr std::size_t mostLines = 60;
    if (!blow.impact.sections.empty() && blow.impact.sections.size() <= mostLines)
        text += "\n" + sectionGrid(blow).text();
    return text;
}

}  // namespace

std::string blowText(const Blow& blow) {
    const Impact& impact = blow.impact;
    std::string text = titleLine(blow.scenario) + paragraph(feedDecisionText(blow.decision())) +
                       groupsLine(blow.scenario) + lawLine(blow.scenario) + "\n";
    text += resultText(blow);
    const SolverWords solver = solverWords(blow);
    text += "\n  method " + solver.name + ", " + std::to_string(impact.contacts) +
            (impact.contacts == 1 ? " contact, " : " contacts, ") + std::to_string(impact.pieces) + " " +
            std::string(solver.pieces) + ", solved in " + inHandyUnit(blow.runTime, Quantity::time) + "\n";
    for (const Alert& alert : blow.alerts) {
        // The line of e says it already, as an estimate.
        if (blow.method.method == Method::lattice && alert.code == AlertCode::reducedAccuracy) continue;
        text += std::string("  ") + (alert.level == AlertLevel::warning ? "warning: " : "note: ") +
                alertText(alert) + "\n";
    }
    return text;
}

}  // namespace drillwave
