// SPDX-License-Identifier: GPL-3.0-or-later
// What the columns of a table probably are, to begin with.
#pragma once

#include <optional>

#include "core/signal/detected_table.h"
#include "core/signal/samples.h"
#include "core/signal/signal_unit.h"

namespace drillwave {

struct SampleGuess {
    SampleSource source;                  ///< times in s where their unit is not stated
    std::optional<NamedSignalUnit> unit;  ///< statedUnit() of the signal
    bool hasTimeUnit = false;             ///< the table states it, or the times are stamps
    bool hasRate = false;                 ///< without a column of times: the table states it with its unit
    std::size_t rivals = 0;               ///< further columns that could as well be the signal
    bool operator==(const SampleGuess&) const = default;
};

/// Time is the first column of stamps or numbers whose unit or name says so, else the first of several; the
/// signal is the first other one whose unit is one of a signal, else one whose name is a force's or a
/// strain's, else the first other one. Columns that count the rows come last. A single column is evenly
/// spaced.
SampleGuess guessedSource(const DetectedTable& table);

/// The kind and unit that the heading of a column states; nothing where it states none, or one that is not
/// known.
std::optional<NamedSignalUnit> statedUnit(const TableColumn& column);

/// The unit of a column of times [s], 1 of stamps; nothing where the heading states none that is known.
std::optional<double> statedTimeUnit(const TableColumn& column);

/// Returns the likely kind of a signal whose heading has no unit: a strain by its name, else a force.
SignalKind likelyKind(const TableColumn& column);

}  // namespace drillwave
