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

#include "core/signal/table_row.h"
#include "core/signal/text_lines.h"

namespace drillwave {

/// What to do with a row whose cells are no numbers.
enum class WrongRows { refused, skipped };

/// Where in a table the samples are.
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

}  // namespace drillwave
