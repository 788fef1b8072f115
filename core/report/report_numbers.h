// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers in a report, each as text for people and as the full number.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/blow.h"
#include "core/blow/outputs.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Contents of one cell of a report table.
struct ReportCell {
    std::string text;
    /// Number shown by the text, in full precision as in JSON; empty if JSON does not have it.
    std::optional<double> number;
};

/// Row of a report table: a name and the cells of all columns.
struct ReportRow {
    std::string key;  ///< name of the value in JSON, or a symbol
    std::string label;
    std::vector<ReportCell> cells;
};

/// Returns the unit of a dimensionless value, such as "I0"; empty for a plain number. For a blow by a
/// prescribed force, energies are shares of its work W.
std::string_view multipleName(Measure measure, const Scenario& scenario);

/// Returns 0 if the output is a share of an energy below 1e-12, which is only rounding; otherwise `value`.
double shareOrZero(const Output& output, double value);

/// Returns the value of an output with its unit as text; work and its shares are in joules.
std::string siText(const Output& output, double value, const Blow& blow,
                   const ReadingStyle& style = plainStyle(), int digits = 5);

/// Returns where in the rod and when a largest force occurs, such as "1.2 m from the hammer, at 300 us".
/// Empty if the force is 0.
std::string placeText(const RodForce& found, const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns rows for all outputs of the scenario except those of solverRows(). Each has the dimensionless
/// value and, if the scenario has units, the value with its unit. The largest stresses also have position and
/// time. Requires a solved blow.
std::vector<ReportRow> resultRows(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns the rows on numerical accuracy: errors, and residuals of momentum and energy balances.
std::vector<ReportRow> solverRows(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns the rows of the four dimensionless groups. If the scenario has units, adds its scales and derived
/// values of the rod, such as its mass.
std::vector<ReportRow> scaleRows(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
