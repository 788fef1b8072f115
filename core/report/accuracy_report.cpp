// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/accuracy_report.h"

#include <algorithm>
#include <cmath>

#include "core/report/accuracy_columns.h"
#include "core/report/report_text.h"
#include "core/text/text_layout.h"

namespace drillwave {

namespace {

std::string label(const AccuracyRow& row) {
    std::string text(name(row.choice.method));
    if (const std::string_view waves = wavesName(row); !waves.empty())
        text += ", " + std::string(waves) + ", " + std::to_string(row.choice.lattice.segments);
    return text;
}

std::string table(const Accuracy& accuracy, const ReadingStyle& style) {
    TextGrid grid;
    grid.add(withTitles(style.said(translatable("method")), accuracyColumns, style));
    for (const AccuracyRow& row : accuracy.rows)
        grid.add(row.outcome == Outcome::rebounded
                     ? withCells(label(row), accuracyColumns, row, style)
                     : std::vector<std::string>{label(row),
                                                style.said({translatable("not solved: %1"), {row.reason}})});
    return grid.text();
}

/// Two blanks before each line of what may have several.
std::string linesOf(const Message& words, const ReadingStyle& style) {
    return indented(style.said(words), 2);
}

Message agreement(const Accuracy& accuracy) {
    for (const AccuracyRow& row : accuracy.rows)
        if (!row.sameAsMoved)
            return {translatable("THE RING DOES NOT GIVE THE NUMBERS OF THE MOVED WAVES at %1 segments: "
                                 "please report this."),
                    {std::to_string(row.choice.lattice.segments)}};
    return translatable("The ring buffer gives the same numbers as the moved waves, to the last bit.");
}

/// Columns of the table.
std::string legend(const Accuracy& accuracy, const ReadingStyle& style) {
    const auto isShort = [](const AccuracyRow& row) {
        return row.outcome == Outcome::rebounded && row.time.runs < wantedRuns;
    };
    std::string text =
        "\n" + style.said(translatable("The table")) + "\n" +
        linesOf(
            translatable("Errors are absolute, forces in F0; lattice and closed form are compared with the "
                         "exact solution.\nestimate: error of e estimated by the method itself. order: "
                         "observed, from the row above.\nforce: largest difference of the force history, at "
                         "ends and middles of all steps; mid-step: at the\nmiddles. A force that is constant "
                         "in each step cannot be closer than half its change in a step."),
            style);
    const Message times{translatable("Times: processor time of a solve for e only. speed: how many times "
                                     "faster than the paper's choice,\n"
                                     "the lattice of %1 segments with moved waves."),
                        {std::to_string(paperSegments)}};
    return text + linesOf(std::ranges::any_of(accuracy.rows, isShort)
                              ? Message(translatable("%1 Rows of over a second have fewer runs."), {times})
                              : times,
                          style);
}

std::string extendedText(const Accuracy& accuracy, const ReadingStyle& style) {
    const Impact& extended = accuracy.extended;
    if (extended.outcome != Outcome::rebounded)
        return linesOf({translatable("It could not be solved in long double: %1."), {extended.reason}},
                       style);
    return linesOf(
        {translatable("Its errors are differences from a solution in long double (%1 bits, %2),\nwhose own "
                      "error is below %3 and included: they show\nrounding and truncation, but not a wrong "
                      "event, as both solutions share the code for events."),
         {std::to_string(accuracy.extendedDigits),
          shownNumber(accuracy.extendedTime, NumberStyle::time, style),
          shownNumber(extended.corError, NumberStyle::error, style)}},
        style);
}

std::string checks(const Accuracy& accuracy, const ReadingStyle& style) {
    const EquationResiduals& residuals = accuracy.residuals;
    const auto line = [&](const Message& equation, double residual) {
        constexpr std::size_t width = 62;
        return "    " + leftAligned(style.said(equation), width) + " " +
               shownNumber(residual, NumberStyle::error, style) + "\n";
    };
    return "\n" + style.said(translatable("The exact solution")) + "\n" + extendedText(accuracy, style) +
           linesOf({translatable("Therefore the histories were inserted into the equations at %1 points, "
                                 "without that code.\nLargest residuals, in F0 (1 + beta/gamma):"),
                    {std::to_string(residuals.points)}},
                   style) +
           line(std::string("g(s) = Fa(s) + g(s - 2 tau) - F(s - 2 tau)"), residuals.wave) +
           line(residuals.loadingLines == 1
                    ? translatable("F' = a (2g - F), a = beta or beta/gamma")
                    : translatable("F' = a (2g - F), a = s_j beta on line j, or beta/gamma"),
                residuals.rate) +
           line(translatable("F = law of the penetration and of the largest one so far"), residuals.law) +
           line(translatable("smallest force"), residuals.leastForce);
}

/// The case, in all digits.
std::string accuracyHeading(const Scenario& scenario, const Accuracy& accuracy, const ReadingStyle& style) {
    const auto whole = [&](double value) { return style.withDecimalSign(formatNumber(value)); };
    const Groups& groups = accuracy.groups;
    return (scenario.title.empty() ? std::string() : scenario.title + "\n") + "  beta " + whole(groups.beta) +
           "  gamma " + whole(groups.gamma) + "  tau " + whole(groups.tau) + "  delta " +
           whole(groups.delta) + "  " +
           style.said({translatable("pulse %1"), {std::string(name(scenario.pulse.shape))}}) + "\n" +
           linesOf({translatable("e = %1, peak force %2 F0"),
                    {whole(accuracy.exact.cor), whole(accuracy.exact.peakForce)}},
                   style);
}

JsonObject rowJson(const AccuracyRow& row) {
    const bool solved = row.outcome == Outcome::rebounded;
    JsonObject object{{"method", name(row.choice.method)},
                      {"outcome", solved ? "rebounded" : "not_solved"},
                      {"cor", row.cor}};
    if (row.choice.method == Method::lattice) {
        object["segments"] = row.choice.lattice.segments;
        object["waves"] = wavesName(row);
        object["same_as_moved"] = row.sameAsMoved;
    }
    if (!solved) object["reason"] = row.reason.text();
    addMembers(object, accuracyColumns, row, solved);
    return object;
}

}  // namespace

std::string accuracyText(const Scenario& scenario, const Accuracy& accuracy, const ReadingStyle& style) {
    std::string text = accuracyHeading(scenario, accuracy, style) + "\n" + table(accuracy, style) +
                       legend(accuracy, style) + linesOf(agreement(accuracy), style);
    if (!std::isnan(accuracy.latticeOrder))
        text += linesOf({translatable("Over the whole ladder the error of e falls with the number of "
                                      "segments to the power of %1."),
                         {shownNumber(accuracy.latticeOrder, NumberStyle::order, style)}},
                        style);
    return text + checks(accuracy, style);
}

std::string accuracyJson(const JsonHead& head, const Accuracy& accuracy) {
    const EquationResiduals& residuals = accuracy.residuals;
    JsonArray rows;
    for (const AccuracyRow& row : accuracy.rows) rows.emplace_back(rowJson(row));
    JsonObject object = headJson(head);
    object["pulse"] = name(head.scenario.pulse.shape);
    object["cor"] = accuracy.exact.cor;
    object["peak_force"] = accuracy.exact.peakForce;
    object["extended"] = JsonObject{{"cor", accuracy.extended.cor},
                                    {"cor_error", accuracy.extended.corError},
                                    {"bits", accuracy.extendedDigits},
                                    {"seconds", accuracy.extendedTime}};
    object["residuals"] = JsonObject{{"wave", residuals.wave},
                                     {"rate", residuals.rate},
                                     {"law", residuals.law},
                                     {"least_force", residuals.leastForce},
                                     {"points", residuals.points}};
    object["lattice_order"] = accuracy.latticeOrder;
    object["rows"] = rows;
    return Json(object).text();
}

std::string accuracyCsv(const Accuracy& accuracy) {
    std::vector<std::string> headers{"method", "waves", "segments", "outcome", "reason", "cor"};
    appendKeys(headers, accuracyColumns);
    return csvText({headers, accuracy.rows.size(), [&](std::size_t i) {
                        const AccuracyRow& row = accuracy.rows[i];
                        const bool solved = row.outcome == Outcome::rebounded;
                        Cells cells{
                            name(row.choice.method),
                            wavesName(row),
                            row.choice.method == Method::lattice ? Cell(row.choice.lattice.segments) : Cell(),
                            solved ? "rebounded" : "not_solved",
                            row.reason.text(),
                            solved ? Cell(row.cor) : Cell()};
                        appendCells(cells, accuracyColumns, row, solved);
                        return cells;
                    }});
}

std::string accuracyText(const Scenario& scenario, const StringAccuracy& accuracy,
                         const ReadingStyle& style) {
    TextGrid grid;
    grid.add(withTitles(style.said(translatable("method")), stringAccuracyColumns, style));
    for (const StringAccuracyRow& row : accuracy.rows)
        grid.add(withCells(std::string(name(row.method)), stringAccuracyColumns, row, style));
    return headingOf(scenario, style) + "\n" + grid.text() + "\n" +
           linesOf(
               {translatable(
                    "error: error of the efficiency, against %1 (cut cells of half the length, error bound "
                    "%2)\nstated: error bound of the method; impulse: error of the impulse on the rock, over "
                    "the hammer's\ncells: polynomial cells, cut at jumps (sweep, map); cells_cut: cut at "
                    "every corner of a wave (run);\nplain: a lattice of constant cells, the usual method"),
                {style.number(accuracy.efficiency, 13), style.bound(accuracy.reference)}},
               style);
}

std::string accuracyJson(const JsonHead& head, const StringAccuracy& accuracy) {
    JsonArray rows;
    for (const StringAccuracyRow& row : accuracy.rows) {
        JsonObject object{{"method", name(row.method)}};
        addMembers(object, stringAccuracyColumns, row);
        rows.emplace_back(object);
    }
    JsonObject object = headJson(head);
    object["efficiency"] = accuracy.efficiency;
    object["efficiency_error"] = accuracy.reference;
    object["rows"] = rows;
    return Json(object).text();
}

std::string accuracyCsv(const StringAccuracy& accuracy) {
    std::vector<std::string> headers{"method"};
    appendKeys(headers, stringAccuracyColumns);
    return csvText({headers, accuracy.rows.size(), [&](std::size_t row) {
                        Cells cells{name(accuracy.rows[row].method)};
                        appendCells(cells, stringAccuracyColumns, accuracy.rows[row]);
                        return cells;
                    }});
}

}  // namespace drillwave
