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
    /// Number that `text` shows, in full precision. Empty if the JSON of the report does not have this
    /// number.
    std::optional<double> number;
};

/// Row of a report table: a name and the cells of all columns.
struct ReportRow {
    std::string key;  ///< name of the value in JSON, or a symbol
    std::string label;
    std::vector<ReportCell> cells;
};

/// Returns the scale of which a dimensionless value is a multiple, such as "I0"; empty for a plain number. If
/// a prescribed force drives the blow, the scale of energies is its work W.
std::string_view multipleName(Measure measure, const Scenario& scenario);

/// Returns 0 if the output is a share of an energy and the magnitude of `value` is below 1e-12, which is only
/// rounding. Otherwise returns `value`.
double shareOrZero(const Output& output, double value);

/// Returns the value of an output as text with its SI unit. Work, and energies given as shares, are converted
/// to joules.
std::string siText(const Output& output, double value, const Blow& blow,
                   const ReadingStyle& style = plainStyle(), int digits = 5);

/// Returns the position and time of the largest force in the rod, `found`, such as "1.2 m from the hammer, at
/// 300 us". Empty if the force is 0.
std::string placeText(const RodForce& found, const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns rows for all outputs of the scenario except those of solverRows(). Each has the dimensionless
/// value and, if the scenario has units, the value with its unit. The largest stresses also have position and
/// time. Requires a solved blow.
std::vector<ReportRow> resultRows(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns the rows on numerical accuracy: error estimates, and residuals of the momentum and energy
/// balances.
std::vector<ReportRow> solverRows(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns rows with the four dimensionless groups. If the scenario has units, rows with its scales, such as
/// F0, follow. The last rows are derived values, such as the mass of the rod, or of hammer and string.
std::vector<ReportRow> scaleRows(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
