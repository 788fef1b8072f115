// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/accuracy_text.h"

#include <cmath>
#include <vector>

#include "core/report/accuracy_columns.h"
#include "core/report/report_text.h"
#include "core/text/number_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

std::string seconds(double value) {
    constexpr std::pair<double, const char*> units[] = {
        {1, " s"}, {1e-3, " ms"}, {1e-6, " us"}, {1e-9, " ns"}};
    for (const auto& [unit, name] : units)
        if (value >= unit || unit == 1e-9)
            return numberText(value / unit, std::chars_format::general, 3) + name;
    return {};
}

std::string shown(double value, NumberStyle style) {
    if (std::isnan(value)) return "-";
    switch (style) {
        case NumberStyle::error:
            return value == 0 ? "0" : numberText(value, std::chars_format::scientific, 1);
        case NumberStyle::time:
            return seconds(value);
        case NumberStyle::count:
            return numberText(value, std::chars_format::fixed, 0);
        case NumberStyle::factor:
            if (value >= 1e4) return numberText(value, std::chars_format::scientific, 1);
            return value >= 100 ? numberText(value, std::chars_format::fixed, 0)
                                : numberText(value, std::chars_format::general, 3);
        case NumberStyle::order:
            return numberText(value, std::chars_format::fixed, 2);
    }
    return {};
}

std::string label(const AccuracyRow& row) {
    std::string text(name(row.choice.method));
    if (const std::string_view waves = wavesName(row); !waves.empty())
        text += ", " + std::string(waves) + ", " + std::to_string(row.choice.lattice.segments);
    return text;
}

std::string table(const Accuracy& accuracy) {
    TextGrid grid;
    std::vector<std::string> titles{"method"};
    for (const AccuracyColumn& column : accuracyColumns)
        if (!column.title.empty()) titles.emplace_back(column.title);
    grid.add(titles);
    for (const AccuracyRow& row : accuracy.rows) {
        std::vector<std::string> cells{label(row)};
        if (row.outcome == Outcome::rebounded) {
            for (const AccuracyColumn& column : accuracyColumns)
                if (!column.title.empty()) cells.push_back(shown(column.value(row), column.style));
        } else {
            cells.push_back("not solved: " + row.reason);
        }
        grid.add(std::move(cells));
    }
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
    const auto error = [](double value) { return shown(value, NumberStyle::error); };
    std::string text = "\nThe exact solution\n";
    text += accuracy.extended.outcome == Outcome::rebounded
                ? "  Its errors are differences to a solution in long double (" +
                      std::to_string(accuracy.extendedDigits) + " bits, " + seconds(accuracy.extendedTime) +
                      "),\n  whose own error is below " + error(accuracy.extended.corError) +
                      " and counted in: they show\n"
                      "  rounding and truncation, but not a mistaken event: both march with the same code "
                      "for events.\n"
                : "  In long double it was not solved: " + accuracy.extended.reason + ".\n";
    text += "  So its histories were put back into the equations at " + std::to_string(residuals.points) +
            " points, without that code.\n"
            "  Largest residuals, in F0 (1 + beta/gamma):\n" +
            "    g(s) = Fa(s) + g(s - 2 tau) - F(s - 2 tau)                     " + error(residuals.wave) +
            "\n    F' = a (2g - F), a = beta or beta/gamma                        " + error(residuals.rate) +
            "\n    F = law of the penetration and of the largest one so far       " + error(residuals.law) +
            "\n    smallest force                                                 " +
            error(residuals.leastForce) + "\n";
    return text;
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
                shown(accuracy.latticeOrder, NumberStyle::order) + ".\n";
    return text + checks(accuracy);
}

}  // namespace drillwave
