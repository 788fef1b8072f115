// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of results that a sweep or a table of cases appends.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/outputs.h"

namespace drillwave {

enum class OutputUnits { dimensionless, si };

/// CSV column of one output (manual, files §4).
struct OutputColumn {
    const Output* output = nullptr;  ///< output shown in the column: an element of outputs()
    OutputUnits units = OutputUnits::dimensionless;

    /// Returns the heading: "peak_force", or "peak_force [N]" in SI units. Outputs without a dimensionless
    /// form always have their unit.
    std::string header() const;
    /// Returns whether the values of the column have a unit.
    bool hasUnit() const { return units == OutputUnits::si || output->isOnlySi(); }
    /// Returns the quantity of the values; Quantity::ratio if they have no unit.
    Quantity quantity() const { return hasUnit() ? output->siQuantity() : Quantity::ratio; }
    /// Returns the factor by which a dimensionless value is multiplied to give the unit of the column; 1 for
    /// a dimensionless column. For an energy it is `scales.energy`.
    double scale(const Scales& scales) const;
    Detail detail() const { return output->detail; }
    /// Returns the value of the output in the unit of the column; empty if it has none (see Output::value).
    std::optional<double> value(const OutputSource& source, const Scales& scales) const;
    bool operator==(const OutputColumn&) const = default;
};

/// Output columns chosen by the user, or the problem why the choice is invalid.
struct OutputChoice {
    std::vector<OutputColumn> columns;
    bool all = false;  ///< whether "all" outputs were requested; see allOutputsOf()
    Message problem;
};

/// Returns the columns read from a list such as "cor,peak_force". For a misspelt output, returns a problem
/// that suggests the nearest one. The word "all" stands for all of outputs(), including outputs that a
/// scenario may not have. Outputs of drillOutputs() must be named individually.
OutputChoice chooseOutputs(std::string_view list, OutputUnits units);

/// Returns the columns of all outputs that a scenario has.
std::vector<OutputColumn> allOutputsOf(const Scenario& scenario, OutputUnits units);

/// Returns the level of detail that the solver must provide for the columns.
Detail detailFor(std::span<const OutputColumn> columns);

/// Returns which optional results must be computed from the histories of the waves to fill the columns, such
/// as the largest forces in the rod.
WaveNumbers waveNumbersFor(std::span<const OutputColumn> columns);

/// Returns which results of a sequence of blows the columns need, so that nothing else is computed.
RequiredMarches drillWishesFor(std::span<const OutputColumn> columns);

/// Returns why one of the columns can have no value for this scenario, and what to do; empty if there is no
/// such column. Columns in SI units, for example, have no values for a dimensionless scenario.
Message columnProblem(std::span<const OutputColumn> columns, const Scenario& scenario);

/// Returns the names of outputs that chooseOutputs() accepts, in their order.
std::vector<std::string_view> outputNames();

}  // namespace drillwave
