// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of one signal, read from a table of text.
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

/// Treatment of rows with cells that are not numbers: the table is refused, or the rows are skipped.
enum class WrongRows { refused, skipped };

/// Columns and format of a signal in a table of text.
struct SampleSource {
    RowFormat format;
    std::size_t firstLine = 1;  ///< first line with samples, counted from 1
    /// Index of the column of times, from 0; nullopt for evenly spaced samples.
    std::optional<std::size_t> timeColumn;
    double timeUnit = 1;          ///< unit of the column of times [s]; not used for times of day
    double interval = 1e-6;       ///< interval between samples, if there is no column of times [s], > 0
    double start = 0;             ///< time of the first sample, if there is no column of times [s]
    std::size_t valueColumn = 0;  ///< index of the column of the signal, from 0
    /// Index of the column of a second gauge on the opposite side of the bar, if any. The mean of both
    /// gauges is used, in which bending cancels.
    std::optional<std::size_t> secondGauge;
    WrongRows wrongRows = WrongRows::refused;
    TextEncoding encoding = TextEncoding::found;
    bool operator==(const SampleSource&) const = default;
};

/// Samples of a signal as recorded, or the reason why they could not be read.
struct Samples {
    /// Times of the samples [s], increasing. Without a column of times they have equal steps from
    /// SampleSource::start.
    std::vector<double> time;
    std::vector<double> value;  ///< values in the unit of the table, one for each time
    /// Number of jumps of the signal: places in the table where two samples have the same time. The second
    /// of them is stored with the next larger double as its time.
    std::size_t jumps = 0;
    std::size_t skipped = 0;       ///< number of skipped rows
    std::size_t firstSkipped = 0;  ///< line of the first skipped row, counted from 1
    /// Longest pause between two samples [s] that is due to skipped rows.
    double skippedTime = 0;
    double skippedAt = 0;  ///< time at which the longest stretch of skipped rows begins [s]
    /// Number of skipped rows that are marked as overload, by a word or a number.
    std::size_t overloads = 0;
    bool hasNulTail = false;             ///< whether the text ended with NUL bytes
    std::vector<double> halfDifference;  ///< (first − second gauge)/2 for each time; empty with one gauge
    /// Number of the line with the problem, from 1; 0 if the problem concerns no line.
    std::size_t problemLine = 0;
    std::string problem;  ///< reason why the samples could not be read; then there are none
    /// Sampling rate [Hz] estimated from first time, last time and number of samples. It is set only if the
    /// times in the table are rounded too coarsely; then `firstTime` is the first time [s].
    std::optional<double> estimatedRate = {};
    double firstTime = 0;
};

/// Largest number of samples (160 MB of memory); a table with more is refused.
inline constexpr std::size_t mostSamples = 10'000'000;

/// Returns the sampling rate [Hz]: the number of intervals between `samples` samples, divided by the time
/// from `first` to `last` [s]. `firstStep` and `lastStep` [s] are the rounding steps of these two times. The
/// rate is rounded to the fewest digits that agree with the rounded times.
double estimatedRate(double first, double last, std::size_t samples, double firstStep, double lastStep);

/// Reads the samples from all rows except blank lines and comments. A row with a cell that is no number is
/// an error with its line number, or is skipped and counted (see WrongRows). Times must increase, except at
/// a jump, where two samples have the same time. If more samples have the same time, the times are too
/// coarse. The result then has a problem and an estimated sampling rate. Calls `tell` with the number of
/// bytes read so far. After a stop request the problem is "stopped".
Samples readSamples(std::istream& in, const SampleSource& source, const std::stop_token& stop = {},
                    const std::function<void(std::uint64_t bytes)>& tell = {});

// Probable contents of the columns of a table, as a proposal.

struct SampleGuess {
    SampleSource source;                  ///< proposed columns; times are in s if their unit is not stated
    std::optional<NamedSignalUnit> unit;  ///< unit of the signal as stated in its heading, see statedUnit()
    bool hasTimeUnit = false;             ///< whether the table states the unit of times, or has times of day
    /// Whether the table states the sampling rate with its unit; only for a table without a column of times.
    bool hasRate = false;
    /// Number of other columns that are equally likely to be the signal. If it is not 0, the user must
    /// choose.
    std::size_t rivals = 0;
    bool operator==(const SampleGuess&) const = default;
};

/// Returns the probable columns of time and signal, as a proposal for the user. Time is the first column of
/// times of day, or of numbers with a unit or name of time, otherwise the first of several columns. The
/// signal is the first other column with a unit of a signal. If there is none, it is the first one with the
/// name of a force or strain, otherwise any other one. Columns with row numbers are the last choice. A single
/// column is taken as evenly spaced samples.
SampleGuess guessedSource(const DetectedTable& table);

/// Returns the kind of signal and unit that the heading of a column states; nullopt if it states no known
/// unit of a signal.
std::optional<NamedSignalUnit> statedUnit(const TableColumn& column);

/// Returns the length in seconds of the unit in the heading of a column of times, such as 1e-3 for "time
/// [ms]". It is 1 for times of day, and nullopt if the heading has no known unit of time.
std::optional<double> statedTimeUnit(const TableColumn& column);

/// Returns the probable kind of a signal whose heading has no unit: a strain if its name says so, else a
/// force.
SignalKind likelyKind(const TableColumn& column);

}  // namespace drillwave
