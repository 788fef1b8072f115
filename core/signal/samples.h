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

namespace drillwave {

/// What to do with a row whose cells are no numbers.
enum class WrongRows { refused, skipped };

/// Where in a table the samples are.
struct SampleSource {
    RowFormat format;
    std::size_t firstLine = 1;               ///< with samples, from 1
    std::optional<std::size_t> timeColumn;   ///< from 0; without one the samples are evenly spaced
    double timeUnit = 1;                     ///< of the time column [s]
    double interval = 1e-6;                  ///< between samples without a time column [s], > 0
    std::size_t valueColumn = 0;             ///< from 0
    std::optional<std::size_t> secondGauge;  ///< the mean of both is taken: bending cancels
    WrongRows wrongRows = WrongRows::refused;
    bool operator==(const SampleSource&) const = default;
};

/// The signal as recorded, or why it could not be read.
struct Samples {
    std::vector<double> time;      ///< [s], increasing; from 0 where samples are evenly spaced
    std::vector<double> value;     ///< as in the table, one for each time
    std::size_t jumps = 0;         ///< times with two values: the second is the next double later
    std::size_t skipped = 0;       ///< rows
    std::size_t firstSkipped = 0;  ///< line of the first of them
    std::size_t problemLine = 0;   ///< 0 where the problem is of no line
    std::string problem;           ///< why not; then there are no samples
};

/// More are refused: 160 MB.
inline constexpr std::size_t mostSamples = 10'000'000;

/// Reads all rows from the first line with samples to the end, blank lines and comments passed over. A row
/// with other cells than numbers where they are needed is refused with its line, or skipped and counted; a
/// time that is not later than the one before is refused, but for two values at one time, a jump. `tell` gets
/// the bytes read so far. Stopped, it ends with the problem "stopped".
Samples readSamples(std::istream& in, const SampleSource& source, const std::stop_token& stop = {},
                    const std::function<void(std::uint64_t bytes)>& tell = {});

}  // namespace drillwave
