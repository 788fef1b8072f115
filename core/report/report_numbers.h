// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a report in rows: as people read them, and in full behind that.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/blow.h"
#include "core/blow/outputs.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Content of one cell.
struct ReportCell {
    std::string text;
    std::optional<double> number;  ///< behind the text, as JSON has it; nothing where it is no number of JSON
};

/// A line: its name, then the cells of the columns.
struct ReportRow {
    std::string key;  ///< the name in JSON, or a symbol
    std::string label;
    std::vector<ReportCell> cells;
};

/// Returns the unit of a multiple: "I0"; empty for a plain number. Energies of a blow by a force are shares
/// of its work W.
std::string_view multipleName(Measure measure, const Scenario& scenario);

/// Shares are known to 1e-12: what is smaller is rounding, and 0.
double shareOrZero(const Output& output, double value);

/// The value of an output in its unit, of work and of its shares in joules.
std::string siText(const Output& output, double value, const Blow& blow,
                   const ReadingStyle& style = plainStyle(), int digits = 5);

/// Where in the rod and when a largest force is: "1.2 m from the hammer, at 300 us"; empty for one of size 0.
std::string placeText(const RodForce& found, const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns every output of the scenario except solverRows(): as a multiple, and in its unit if the scenario
/// has units; with place and time for the largest stresses. Requires a solved blow.
std::vector<ReportRow> resultRows(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns the rows on the numerical error: errors and residuals of the balances.
std::vector<ReportRow> solverRows(const Blow& blow, const ReadingStyle& style = plainStyle());

/// The four groups and, where the scenario has units, the scales and what follows for the rod.
std::vector<ReportRow> scaleRows(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
