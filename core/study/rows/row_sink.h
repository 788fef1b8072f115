// SPDX-License-Identifier: GPL-3.0-or-later
// Where the rows of a sweep or a table go: a file, an array, a plot.
#pragma once

#include <string>
#include <string_view>

#include "core/study/rows/row_block.h"
#include "core/study/rows/row_column.h"

namespace drillwave {

/// Takes rows as numbers, in their order, for any number of threads that solve them.
class RowSink {
  public:
    virtual ~RowSink() = default;

    /// Receives the description of the rows once, before them. False stops the run.
    virtual bool begin(const RowHeader& header) = 0;

    /// Does work that is possible before the turn of these rows: it runs on the threads that solve them, for
    /// several blocks at once, and its result in `prepared` (empty at first) is passed to take() with the
    /// rows.
    virtual void prepare(const RowBlock& rows, std::string& prepared) const {
        (void)rows;
        (void)prepared;
    }

    /// Takes the next rows, on the calling thread. They are invalid afterwards. Returns false to stop the run
    /// (for example if the disk is full).
    virtual bool take(const RowBlock& rows, std::string_view prepared) = 0;
};

}  // namespace drillwave
