// SPDX-License-Identifier: GPL-3.0-or-later
// How far a run of rows has come.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/numeric/ordered_work.h"
#include "core/study/rows/row_block.h"
#include "core/text/message.h"

namespace drillwave {

/// Maximum number of different reasons over all rows; later ones only count in `failed`.
inline constexpr std::size_t maximumRowReasons = 3;

/// Progress or end of a run of rows.
struct RowCounts {
    std::uint64_t rows = 0;            ///< delivered
    std::uint64_t failed = 0;          ///< of these, not solved: they have no outputs
    std::vector<RowFailure> failures;  ///< the first maximumRowReasons reasons, in the order of the rows
    WorkEnd end = WorkEnd::finished;
    Message refusal = {};  ///< why nothing was run, not even begun; empty otherwise

    /// Counts the next rows.
    void add(const RowBlock& block) {
        rows += block.size();
        for (const RowFailure& failure : block.failures()) {
            failed += failure.rows;
            addFailure(failures, failure);
        }
        if (failures.size() > maximumRowReasons) failures.resize(maximumRowReasons);
    }
};

/// Called from time to time with the progress.
using RowProgress = std::function<void(const RowCounts&)>;

}  // namespace drillwave
