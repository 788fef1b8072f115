// SPDX-License-Identifier: GPL-3.0-or-later
// Where the rows of a sweep or a table go: a file, an array, a plot.
#pragma once

#include <string>
#include <string_view>

#include "core/study/rows/row_block.h"
#include "core/study/rows/row_column.h"

namespace drillwave {

/// Takes rows as numbers, in their order, whatever the number of threads that solve them.
class RowSink {
  public:
    virtual ~RowSink() = default;

    /// Receives the description of the rows once, before them. False stops the run.
    virtual bool begin(const RowHeader& header) = 0;

    /// Work that can be done before the turn of these rows has come: it runs on the threads that solve them,
    /// for several blocks at once, and what it leaves in `prepared` (empty at first) comes back with its
    /// rows.
    virtual void prepare(const RowBlock& rows, std::string& prepared) const {
        (void)rows;
        (void)prepared;
    }

    /// The next rows, on the thread that called. They are gone afterwards. False stops the run (the disk is
    /// full, say).
    virtual bool take(const RowBlock& rows, std::string_view prepared) = 0;
};

}  // namespace drillwave
