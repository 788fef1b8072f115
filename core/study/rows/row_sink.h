// SPDX-License-Identifier: GPL-3.0-or-later
// Destination of the rows of a sweep or a table: a file, an array or a plot.
#pragma once

#include <string>
#include <string_view>

#include "core/study/rows/row_block.h"
#include "core/study/rows/row_column.h"

namespace drillwave {

/// Receiver of the result rows of a sweep or table, such as a CSV file. Rows are received in order, for any
/// number of threads.
class RowSink {
  public:
    virtual ~RowSink() = default;

    /// Receives the headings and the meaning of the columns, once and before the first row. Returns false to
    /// stop the run.
    virtual bool begin(const RowHeader& header) = 0;

    /// Prepares a block of rows on the thread that computed it, for example by formatting its text. May be
    /// called on several threads at the same time. The result in `prepared` (initially empty) is passed to
    /// take() with the rows.
    virtual void prepare(const RowBlock& rows, std::string& prepared) const {
        (void)rows;
        (void)prepared;
    }

    /// Receives the next block of rows, on the calling thread; the block is invalid afterwards. Returns false
    /// to stop the run, for example if the disk is full.
    virtual bool take(const RowBlock& rows, std::string_view prepared) = 0;
};

}  // namespace drillwave
