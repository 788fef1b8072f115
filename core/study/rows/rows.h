// SPDX-License-Identifier: GPL-3.0-or-later
// What sweeps and tables say about the rows they write.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/ordered_rows.h"

namespace drillwave {

/// Most wave pieces that one row may take, where nothing else is asked for. A piece takes 0.05 to 1.5 µs: the
/// costliest row is given up after one or two seconds, and nearly all take less than a thousand pieces.
inline constexpr long defaultWorkLimit = 1'000'000;

/// Rows that were not solved for one reason.
struct RowFailure {
    std::string reason;
    std::uint64_t rows = 0;
    bool operator==(const RowFailure&) const = default;
};

/// Adds to the rows of that reason.
inline void addFailure(std::vector<RowFailure>& failures, const RowFailure& more) {
    const auto same = std::ranges::find(failures, more.reason, &RowFailure::reason);
    if (same == failures.end())
        failures.push_back(more);
    else
        same->rows += more.rows;
}

/// Most reasons that are told apart over all rows; those that come later count in `failed` alone.
inline constexpr std::size_t maximumRowReasons = 3;

/// How far a table has come, or got.
struct RowCounts {
    std::uint64_t rows = 0;            ///< written, without the header
    std::uint64_t failed = 0;          ///< of these, not solved: their output cells are empty
    std::vector<RowFailure> failures;  ///< the first maximumRowReasons reasons, in the order of the rows
    RowsEnd end = RowsEnd::finished;

    /// Counts a chunk of rows.
    void add(std::uint64_t chunkRows, const std::vector<RowFailure>& chunkFailures) {
        rows += chunkRows;
        for (const RowFailure& failure : chunkFailures) {
            failed += failure.rows;
            addFailure(failures, failure);
        }
        if (failures.size() > maximumRowReasons) failures.resize(maximumRowReasons);
    }
};

/// Takes the next bytes of the table; false stops the run (the disk is full, say).
using WriteText = std::function<bool(std::string_view)>;
/// Told now and then how far it is.
using RowProgress = std::function<void(const RowCounts&)>;

}  // namespace drillwave
