// SPDX-License-Identifier: GPL-3.0-or-later
// What the columns of a table probably are, to begin with.
#pragma once

#include <optional>

#include "core/signal/detected_table.h"
#include "core/signal/samples.h"
#include "core/signal/signal_unit.h"

namespace drillwave {

struct SampleGuess {
    SampleSource source;                  ///< times in s where their unit is not known
    std::optional<NamedSignalUnit> unit;  ///< guessedUnit() of the signal
    bool operator==(const SampleGuess&) const = default;
};

/// Time is the first column of numbers whose unit or name says so, else the first of several; the signal is
/// the first other one whose unit is that of a force, a strain or a bridge, else the first other one. A
/// single column is evenly spaced.
SampleGuess guessedSource(const DetectedTable& table);

/// The kind and unit of a column: N where its name is all that it says, nothing where it has no name either
/// or says one that is not known.
std::optional<NamedSignalUnit> guessedUnit(const TableColumn& column);

/// The unit of a column of times [s]: 1 where its name is all that it says, nothing where it has no name
/// either or says one that is not known.
std::optional<double> guessedTimeUnit(const TableColumn& column);

}  // namespace drillwave
