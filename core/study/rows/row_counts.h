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

/// Most reasons that are told apart over all rows; those that come later count in `failed` alone.
inline constexpr std::size_t maximumRowReasons = 3;

/// How far a run of rows has come, or got.
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

/// Told now and then how far it is.
using RowProgress = std::function<void(const RowCounts&)>;

}  // namespace drillwave
