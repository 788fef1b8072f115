// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/accuracy_report.h"

#include <cmath>

#include "core/model/version.h"
#include "core/report/accuracy_columns.h"
#include "core/report/json_value.h"
#include "core/report/report_text.h"
#include "core/text/csv.h"

namespace drillwave {

namespace {

std::string label(const AccuracyRow& row) {
    std::string text(name(row.choice.method));
    if (const std::string_view waves = wavesName(row); !waves.empty())
        text += ", " + std::string(waves) + ", " + std::to_string(row.choice.lattice.segments);
    return text;
}

std::string table(const Accuracy& accuracy) {
    TextGrid grid;
    grid.add(withTitles("method", accuracyColumns));
    for (const AccuracyRow& row : accuracy.rows)
        grid.add(row.outcome == Outcome::rebounded
                     ? withCells(label(row), accuracyColumns, row)
                     : std::vector<std::string>{label(row), "not solved: " + row.reason});
    return grid.text();
}

std::string agreement(const Accuracy& accuracy) {
    for (const AccuracyRow& row : accuracy.rows)
        if (!row.sameAsMoved)
            return "  THE RING DOES NOT GIVE THE NUMBERS OF THE MOVED WAVES at " +
                   std::to_string(row.choice.lattice.segments) + " segments: please report this.\n";
    return "  The ring buffer gives every number of the moved waves, to the last bit.\n";
}

std::string checks(const Accuracy& accuracy) {
    const EquationResiduals& residuals = accuracy.residuals;
    const auto error = [](double value) { return shownNumber(value, NumberStyle::error); };
    std::string text = "\nThe exact solution\n";
    text += accuracy.extended.outcome == Outcome::rebounded
                ? "  Its errors are differences to a solution in long double (" +
                      std::to_string(accuracy.extendedDigits) + " bits, " +
                      shownNumber(accuracy.extendedTime, NumberStyle::time) +
                      "),\n  whose own error is below " + error(accuracy.extended.corError) +
                      " and counted in: they show\n"
                      "  rounding and truncation, but not a mistaken event: both march with the same code "
                      "for events.\n"
                : "  In long double it was not solved: " + accuracy.extended.reason + ".\n";
    text += "  So its histories were put back into the equations at " + std::to_string(residuals.points) +
            " points, without that code.\n"
            "  Largest residuals, in F0 (1 + beta/gamma):\n" +
            "    g(s) = Fa(s) + g(s - 2 tau) - F(s - 2 tau)                     " + error(residuals.wave) +
            (residuals.loadingLines == 1
                 ? "\n    F' = a (2g - F), a = beta or beta/gamma                        "
                 : "\n    F' = a (2g - F), a = s_j beta on line j, or beta/gamma         ") +
            error(residuals.rate) + "\n    F = law of the penetration and of the largest one so far       " +
            error(residuals.law) + "\n    smallest force                                                 " +
            error(residuals.leastForce) + "\n";
    return text;
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
    if (!solved) object["reason"] = row.reason;
    addMembers(object, accuracyColumns, row, solved);
    return object;
}

}  // namespace

std::string accuracyText(const Scenario& scenario, const Accuracy& accuracy) {
    const Groups& groups = accuracy.groups;
    std::string text = scenario.title.empty() ? std::string() : scenario.title + "\n";
    text += "  beta " + formatNumber(groups.beta) + "  gamma " + formatNumber(groups.gamma) + "  tau " +
            formatNumber(groups.tau) + "  delta " + formatNumber(groups.delta) + "  pulse " +
            std::string(name(scenario.pulse.shape)) + "\n  e = " + formatNumber(accuracy.exact.cor) +
            ", peak force " + formatNumber(accuracy.exact.peakForce) + " F0\n\n";
    text += table(accuracy);
    text +=
        "\nThe table\n"
        "  Errors are absolute, forces in F0; those of lattice and closed form against the exact solution.\n"
        "  estimate: what the method itself says about its error of e. order: observed, from the row above.\n"
        "  force: largest difference of the force history, at ends and middles of all steps; mid-step: at "
        "the\n"
        "  middles. A force that is constant in each step cannot come closer than half its change in a "
        "step.\n"
        "  Times: processor time of a solve for e alone. speed: how many times faster than the paper's "
        "choice,\n"
        "  the lattice of " +
        std::to_string(paperSegments) + " segments with moved waves.";
    for (const AccuracyRow& row : accuracy.rows)
        if (row.outcome == Outcome::rebounded && row.time.runs < wantedRuns) {
            text += " Rows of over a second have fewer runs.";
            break;
        }
    text += "\n" + agreement(accuracy);
    if (!std::isnan(accuracy.latticeOrder))
        text += "  Over the whole ladder the error of e falls with the number of segments to the power of " +
                shownNumber(accuracy.latticeOrder, NumberStyle::order) + ".\n";
    return text + checks(accuracy);
}

std::string accuracyJson(const Scenario& scenario, const std::string& scenarioText,
                         const Accuracy& accuracy) {
    const EquationResiduals& residuals = accuracy.residuals;
    JsonArray rows;
    for (const AccuracyRow& row : accuracy.rows) rows.emplace_back(rowJson(row));
    const JsonObject object{
        {"version", versionText},
        {"title", scenario.title},
        {"scenario", scenarioText},
        {"pulse", name(scenario.pulse.shape)},
        {"groups", groupsJson(accuracy.groups)},
        {"cor", accuracy.exact.cor},
        {"peak_force", accuracy.exact.peakForce},
        {"extended", JsonObject{{"cor", accuracy.extended.cor},
                                {"cor_error", accuracy.extended.corError},
                                {"bits", accuracy.extendedDigits},
                                {"seconds", accuracy.extendedTime}}},
        {"residuals", JsonObject{{"wave", residuals.wave},
                                 {"rate", residuals.rate},
                                 {"law", residuals.law},
                                 {"least_force", residuals.leastForce},
                                 {"points", residuals.points}}},
        {"lattice_order", accuracy.latticeOrder},
        {"rows", rows},
    };
    return Json(object).text();
}

std::string accuracyCsv(const Accuracy& accuracy) {
    std::string csv = "method,waves,segments,outcome,reason,cor";
    appendKeys(csv, accuracyColumns);
    csv += "\n";
    for (const AccuracyRow& row : accuracy.rows) {
        const bool solved = row.outcome == Outcome::rebounded;
        csv += std::string(name(row.choice.method)) + "," + std::string(wavesName(row)) + ",";
        if (row.choice.method == Method::lattice) csv += std::to_string(row.choice.lattice.segments);
        csv += std::string(solved ? ",rebounded," : ",not_solved,") + csvCell(row.reason) + ",";
        if (solved) appendNumber(csv, row.cor);
        appendCells(csv, accuracyColumns, row, solved);
        csv += "\n";
    }
    return csv;
}

std::string accuracyText(const Scenario& scenario, const StringAccuracy& accuracy) {
    TextGrid grid;
    grid.add(withTitles("method", stringAccuracyColumns));
    for (const StringAccuracyRow& row : accuracy.rows)
        grid.add(withCells(std::string(name(row.method)), stringAccuracyColumns, row));
    return headingOf(scenario) + "\n" + grid.text() + "\n  error: of the efficiency, against " +
           rounded(accuracy.efficiency, 13) + " (cut cells half as large again, stated error " +
           boundText(accuracy.reference) +
           ")\n  stated: what the method says of it; impulse: error of the impulse on the rock, of the "
           "hammer's\n  cells: polynomial cells, cut at jumps (sweep, map); cells_cut: cut at every corner "
           "of a wave (run);\n  plain: a lattice of constant cells, as others have it\n";
}

std::string accuracyJson(const Scenario&, const std::string& scenarioText, const StringAccuracy& accuracy) {
    JsonArray rows;
    for (const StringAccuracyRow& row : accuracy.rows) {
        JsonObject object{{"method", name(row.method)}};
        addMembers(object, stringAccuracyColumns, row);
        rows.emplace_back(object);
    }
    return Json(JsonObject{{"version", versionText},
                           {"efficiency", accuracy.efficiency},
                           {"efficiency_error", accuracy.reference},
                           {"rows", rows},
                           {"scenario", scenarioText}})
        .text();
}

std::string accuracyCsv(const StringAccuracy& accuracy) {
    std::string csv = "method";
    appendKeys(csv, stringAccuracyColumns);
    csv += "\n";
    for (const StringAccuracyRow& row : accuracy.rows) {
        csv += name(row.method);
        appendCells(csv, stringAccuracyColumns, row);
        csv += "\n";
    }
    return csv;
}

}  // namespace drillwave
