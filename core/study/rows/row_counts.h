// SPDX-License-Identifier: GPL-3.0-or-later
// Number of rows that a run has completed, and why some were not solved.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/numeric/ordered_work.h"
#include "core/study/rows/row_block.h"
#include "core/text/message.h"

namespace drillwave {

/// Maximum number of different reasons for unsolved rows that RowCounts lists. Rows with further reasons
/// count only in RowCounts::failed.
inline constexpr std::size_t maximumRowReasons = 3;

/// Counts of the rows that a run of a sweep or table has completed so far, or at its end.
struct RowCounts {
    std::uint64_t rows = 0;    ///< rows delivered to the sink
    std::uint64_t failed = 0;  ///< rows delivered that were not solved and have no outputs
    /// First maximumRowReasons reasons for unsolved rows, in the order of the rows.
    std::vector<RowFailure> failures;
    WorkEnd end = WorkEnd::finished;
    Message refusal = {};  ///< reason why the run was refused before any row; empty if it was started

    /// Adds the solved and failed rows of the next block to the counts.
    void add(const RowBlock& block) {
        rows += block.size();
        for (const RowFailure& failure : block.failures()) {
            failed += failure.rows;
            addFailure(failures, failure);
        }
        if (failures.size() > maximumRowReasons) failures.resize(maximumRowReasons);
    }
};

/// Callback for progress, called from time to time with the rows completed so far.
using RowProgress = std::function<void(const RowCounts&)>;

}  // namespace drillwave
