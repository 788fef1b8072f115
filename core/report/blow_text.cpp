// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_text.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "core/blow/blow.h"
#include "core/blow/outputs.h"
#include "core/report/alert_words.h"
#include "core/report/feed_words.h"
#include "core/report/report_numbers.h"
#include "core/report/report_text.h"
#include "core/report/section_grid.h"
#include "core/report/strength_words.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

enum class LineKind {
    plain,
    part,          ///< of what the line before tells
    afterContact,  ///< only where bit and rock have met
    balance,       ///< with the error of the energy balance behind that of the momentum
};

/// A line of the summary: an output under the words of the summary.
struct SummaryLine {
    std::string_view output;
    const char* label;
    OutputOf of = OutputOf::anyBlow;
    LineKind kind = LineKind::plain;
    const char* remark = nullptr;  ///< replaces the number %1, or follows it
};

/// Lines of the summary: multiples and SI for uniform rods, SI for drill strings. Lines before and after them
/// are added separately.
constexpr auto summaryLines = std::to_array<SummaryLine>({
    {"efficiency_recovered", translatable("and returned with the hammer"), OutputOf::hammer, LineKind::part},
    {"rock_work", translatable("work on the rock"), OutputOf::drillString},
    {"impulse", translatable("impulse 1 + e"), OutputOf::uniformRod},
    {"impulse", translatable("impulse on the rock"), OutputOf::drillString, LineKind::plain,
     translatable("%1 of the hammer's")},
    {"cor", translatable("restitution e of the string"), OutputOf::drillString},
    {"peak_force", translatable("peak force"), OutputOf::uniformRod},
    {"peak_force", translatable("peak force on the rock"), OutputOf::drillString},
    {"max_penetration", translatable("largest penetration"), OutputOf::uniformRod},
    {"max_penetration", translatable("largest penetration"), OutputOf::drillString},
    {"residual_penetration", translatable("residual penetration"), OutputOf::uniformRod},
    {"residual_penetration", translatable("residual penetration"), OutputOf::drillString},
    {"peak_compression", translatable("largest compression"), OutputOf::uniformRod},
    {"peak_tension", translatable("largest tension"), OutputOf::uniformRod},
    {"peak_compression_after", translatable("compression after"), OutputOf::uniformRod, LineKind::part},
    {"peak_tension_after", translatable("tension after"), OutputOf::uniformRod, LineKind::part},
    {"percussion_power", translatable("percussion power"), OutputOf::uniformRod},
    {"penetration_rate", translatable("penetration rate"), OutputOf::uniformRod, LineKind::plain,
     translatable("%1 of blows like this one")},
    {"first_contact_time", translatable("first contact"), OutputOf::uniformRod},
    {"separation_time", translatable("last separation"), OutputOf::uniformRod},
    {"contact_duration", translatable("time in contact"), OutputOf::uniformRod},
    {"first_contact_time", translatable("first contact"), OutputOf::drillString, LineKind::afterContact},
    {"separation_time", translatable("last separation"), OutputOf::drillString, LineKind::afterContact},
    {"contact_duration", translatable("time in contact"), OutputOf::drillString, LineKind::afterContact},
    {"piston_separation_time", translatable("hammer separates"), OutputOf::hammer},
    {"hammer_rebound_velocity", translatable("hammer rebound"), OutputOf::hammer, LineKind::plain,
     translatable("away from the rock")},
    {"work_ratio", translatable("hammer work W"), OutputOf::uniformRod},
    {"rock_work", translatable("in the rock"), OutputOf::uniformRod, LineKind::part},
    {"rebound_energy", translatable("in the rebound"), OutputOf::uniformRod, LineKind::part},
    {"residual_wave_energy", translatable("in waves"), OutputOf::uniformRod, LineKind::part},
    {"momentum_residual", translatable("balance errors"), OutputOf::uniformRod, LineKind::balance,
     translatable("%1 of I0, %2 of W")},
});

std::string labelOf(const SummaryLine& line, const ReadingStyle& style) {
    return (line.kind == LineKind::part ? "  " : "") + style.said(line.label);
}

constexpr int digitsOfRod = 6, digitsOfString = 5;

/// As a multiple, in SI, and of a largest stress where and when.
std::vector<std::string> cellsOfRod(const SummaryLine& line, const Output& output, double value,
                                    const Blow& blow, const ReadingStyle& style) {
    std::vector<std::string> cells{labelOf(line, style)};
    if (line.kind == LineKind::balance) {
        cells.push_back(style.said(
            {line.remark, {style.number(value, 2), style.number(blow.summary.energy.residual, 2)}}));
        return cells;
    }
    if (output.isOnlySi()) {
        const std::string text = siText(output, value, blow, style, 4);
        cells.push_back(line.remark ? style.said({line.remark, {text}}) : text);
        return cells;
    }
    cells.push_back(style.number(value) + " " + std::string(multipleName(output.measure, blow.scenario)));
    if (hasUnits(blow.scenario)) cells.push_back(siText(output, value, blow, style, digitsOfRod));
    if (output.load && value > 0)
        cells.push_back(placeText((*blow.summary.rodForces)[*output.load], blow, style));
    return cells;
}

/// In SI where there is a unit; empty where there is no such time, or no contact.
std::vector<std::string> cellsOfString(const SummaryLine& line, const Output& output, double value,
                                       const Blow& blow, const ReadingStyle& style) {
    if (output.measure == Measure::time && std::isnan(value)) return {};
    if (line.kind == LineKind::afterContact && blow.summary.contacts == 0) return {};
    const bool isPlain = output.measure == Measure::number || output.measure == Measure::share;
    std::vector<std::string> cells{labelOf(line, style),
                                   isPlain ? style.number(value) : siText(output, value, blow, style)};
    const char* remark = isForced(blow.scenario) && output.measure == Measure::impulse
                             ? translatable("%1 of the force's")
                             : line.remark;
    if (remark) cells.push_back(style.said({remark, {style.number(value)}}));
    return cells;
}

void addSummary(TextGrid& grid, const Blow& blow, const ReadingStyle& style) {
    for (const SummaryLine& line : summaryLines) {
        if (!concerns(line.of, blow.scenario)) continue;
        const Output& output = *findOutput(line.output);
        if (!output.problem(blow.scenario).isEmpty()) continue;
        const std::optional<double> value = output.value({blow.summary, blow.scenario});
        if (!value) continue;
        std::vector<std::string> cells =
            line.of == OutputOf::uniformRod
                ? cellsOfRod(line, output, shareOrZero(output, *value), blow, style)
                : cellsOfString(line, output, *value, blow, style);
        if (!cells.empty()) grid.add(std::move(cells));
    }
}

/// Returns the text of the margin over the largest of the four required feeds.
Message marginMessage(double margin, double effective, const ReadingStyle& style) {
    const auto newton = [&](double force) { return style.quantity(force, Quantity::force, 4); };
    const double need = effective / (1 + margin);
    return {
        margin < 0 ? translatable("%1, not met: short by %2 (%3)")
                   : translatable("%1, met with %2 (%3) to spare"),
        {newton(need), newton(std::abs(effective - need)), style.number(100 * std::abs(margin), 3) + " %"}};
}

Message neededThrust(const Blow& blow, const ReadingStyle& style) {
    const std::optional<FeedForce>& force = blow.feed->force;
    const int digits = blow.feed->gapsHavePeriod ? digitsOfRod : digitsOfString;
    const auto newton = [&](double thrust) { return style.quantity(thrust, Quantity::force, digits); };
    const std::string needed = newton(blow.feed->need(ThrustCase::scenario).thrust);
    if (!force) return needed;
    if (!force->weight) return {translatable("%1, installed %2"), {needed, newton(force->thrust)}};
    return {translatable("%1, installed %2, effective %3"),
            {needed, newton(force->thrust), newton(force->effective())}};
}

void addFeed(TextGrid& grid, const Blow& blow, const ReadingStyle& style) {
    if (!blow.feed) return;
    const auto add = [&](const std::string& before, const char* label, const Message& words) {
        grid.add({before + style.said(label), style.said(words)});
    };
    const std::optional<FeedForce>& force = blow.feed->force;
    add("", translatable("feed required"), neededThrust(blow, style));
    if (const std::optional<double> margin = blow.thrustMargin())
        add("  ", translatable("at every gap"), marginMessage(*margin, force->effective(), style));
}

/// Returns the main output of a blow with its error.
void addMain(TextGrid& grid, const Blow& blow, const ReadingStyle& style) {
    const OutputSource numbers{blow.summary, blow.scenario};
    const MainOutput main = mainOutput(blow.scenario);
    const bool isEstimate = blow.method.method == Method::lattice;
    grid.add({style.said(Message::ofTable(main.value->title)),
              style.number(*main.value->value(numbers), 12) + "  " +
                  style.said({isEstimate ? translatable("(error estimated as %1)")
                                         : translatable("(error below %1)"),
                              {style.bound(*main.error->value(numbers))}})});
}

std::string resultText(const Blow& blow, const ReadingStyle& style) {
    TextGrid grid(CellAlignment::left);
    addMain(grid, blow, style);
    addSummary(grid, blow, style);
    addFeed(grid, blow, style);
    std::string text = grid.text();
    if (const TextGrid energies = energyGrid(blow, style); !energies.rows().empty())
        text += "\n" + energies.text();
    // a thousand lines are for a file
    constexpr std::size_t mostLines = 60;
    if (!blow.impact.sections.empty() && blow.impact.sections.size() <= mostLines)
        text += "\n" + sectionGrid(blow, style).text();
    const Message first = strengthSentence(blow.scenario, sectionStresses(blow.scenario, blow.impact), style);
    if (!first.isEmpty()) text += "\n" + paragraph(style.said(first));
    return text;
}

/// "method exact, 1 contact, 12 pieces, solved in 80 us".
Message solvedMessage(const Blow& blow, const ReadingStyle& style) {
    const SolverWords solver = solverWords(blow);
    const int contacts = blow.impact.contacts;
    return {translatable("method %1, %2, %3, solved in %4"),
            {solver.name,
             counted(static_cast<std::uint64_t>(contacts), translatable("%1 contact"),
                     translatable("%1 contacts")),
             solver.pieces, style.quantity(blow.runTime, Quantity::time)}};
}

}  // namespace

std::string blowText(const Blow& blow, const ReadingStyle& style) {
    std::string text = titleLine(blow.scenario) + paragraph(estimateText(blow.scenario, blow.feed, style)) +
                       groupsLine(blow.scenario, style) + lawLine(blow.scenario, style) + "\n";
    text += resultText(blow, style);
    text += "\n  " + style.said(solvedMessage(blow, style)) + "\n";
    for (const Alert& alert : blow.alerts) {
        // The line of e says it already, as an estimate.
        if (blow.method.method == Method::lattice && alert.code == AlertCode::reducedAccuracy) continue;
        text += "  " +
                style.said({alert.level == AlertLevel::warning ? translatable("warning: %1")
                                                               : translatable("note: %1"),
                            {alertMessage(alert, style)}}) +
                "\n";
    }
    return text;
}

}  // namespace drillwave
