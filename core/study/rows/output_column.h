// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of results that a sweep or a table appends.
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
    const Output* output = nullptr;  ///< of outputs()
    OutputUnits units = OutputUnits::dimensionless;

    /// Returns "peak_force", or in SI "peak_force [N]"; with its unit if it has no dimensionless number.
    std::string header() const;
    /// Whether its numbers are in a unit.
    bool hasUnit() const { return units == OutputUnits::si || output->isOnlySi(); }
    /// The quantity of the numbers: `ratio` where they are in no unit.
    Quantity quantity() const { return hasUnit() ? output->siQuantity() : Quantity::ratio; }
    /// Returns the unit of the output in its numbers; for an energy that of the scales.
    double scale(const Scales& scales) const;
    Detail detail() const { return output->detail; }
    /// nullopt where there is no number (Output::value).
    std::optional<double> value(const OutputSource& source, const Scales& scales) const;
    bool operator==(const OutputColumn&) const = default;
};

/// The columns chosen, or why not.
struct OutputChoice {
    std::vector<OutputColumn> columns;
    bool all = false;  ///< all were requested; see allOutputsOf()
    Message problem;
};

/// Reads "cor,peak_force"; names the nearest output for a mistyped one. "all" are all of outputs(), including
/// those that a scenario may not have; drillOutputs() must be named.
OutputChoice chooseOutputs(std::string_view list, OutputUnits units);

/// Returns all outputs of such a scenario.
std::vector<OutputColumn> allOutputsOf(const Scenario& scenario, OutputUnits units);

/// Returns the detail required from the solver.
Detail detailFor(std::span<const OutputColumn> columns);

/// Returns the numbers required from the waves.
WaveNumbers waveNumbersFor(std::span<const OutputColumn> columns);

/// Returns the numbers required from a march.
RequiredMarches drillWishesFor(std::span<const OutputColumn> columns);

/// Returns why a column would be empty for every such scenario and what to do; empty if none would be.
Message columnProblem(std::span<const OutputColumn> columns, const Scenario& scenario);

/// The names that chooseOutputs() knows, in order.
std::vector<std::string_view> outputNames();

}  // namespace drillwave
