// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of one signal, read from a table of text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/signal/detected_table.h"
#include "core/signal/signal_unit.h"
#include "core/signal/table_row.h"
#include "core/signal/text_lines.h"

namespace drillwave {

/// Treatment of rows whose cells are no numbers.
enum class WrongRows { refused, skipped };

/// Place of the samples in a table.
struct SampleSource {
    RowFormat format;
    std::size_t firstLine = 1;               ///< with samples, from 1
    std::optional<std::size_t> timeColumn;   ///< from 0; without one the samples are evenly spaced
    double timeUnit = 1;                     ///< of the time column [s]; of stamps it is not asked
    double interval = 1e-6;                  ///< between samples without a time column [s], > 0
    double start = 0;                        ///< time of the first of these [s]
    std::size_t valueColumn = 0;             ///< from 0
    std::optional<std::size_t> secondGauge;  ///< the mean of both is taken: bending cancels
    WrongRows wrongRows = WrongRows::refused;
    TextEncoding encoding = TextEncoding::found;
    bool operator==(const SampleSource&) const = default;
};

/// The signal as recorded, or why it could not be read.
struct Samples {
    std::vector<double> time;      ///< [s], increasing; from 0 where samples are evenly spaced
    std::vector<double> value;     ///< as in the table, one for each time
    std::size_t jumps = 0;         ///< times with two values: the second is the next double later
    std::size_t skipped = 0;       ///< rows
    std::size_t firstSkipped = 0;  ///< line of the first of them
    double skippedTime = 0;        ///< longest time between two samples that skipped rows have opened [s]
    double skippedAt = 0;          ///< where it begins [s]
    std::size_t overloads = 0;     ///< of the skipped rows, those with a word or a number for "too large"
    bool hasNulTail = false;       ///< NUL bytes stood at the end
    std::vector<double> halfDifference;  ///< of the first and the second gauge, where there are two
    std::size_t problemLine = 0;         ///< 0 where the problem is of no line
    std::string problem;                 ///< why not; then there are no samples
    /// Estimated rate of times that are too coarse, from the first, the last and their number, rounded as far
    /// as their steps allow [Hz], and the first time [s].
    std::optional<double> estimatedRate = {};
    double firstTime = 0;
};

/// More are refused: 160 MB.
inline constexpr std::size_t mostSamples = 10'000'000;

/// Returns the rate that follows from the first time, the last and the number of samples, to as few digits as
/// the steps of the clock leave open: `firstStep` and `lastStep` are how far it jumps there [s].
double estimatedRate(double first, double last, std::size_t samples, double firstStep, double lastStep);

/// Reads all rows from the first line with samples to the end, blank lines and comments passed over. A row
/// with other cells than numbers where they are needed is refused with its line, or skipped and counted; a
/// time that is not later than the one before is refused, but for two values at one time, a jump; of a time
/// that occurs more often the first line is named and a rate estimated. `tell` gets the bytes read so far.
/// Stopped, it ends with the problem "stopped".
Samples readSamples(std::istream& in, const SampleSource& source, const std::stop_token& stop = {},
                    const std::function<void(std::uint64_t bytes)>& tell = {});

// Probable contents of the columns of a table, as a start.

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
