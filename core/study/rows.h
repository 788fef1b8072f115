// What sweeps and tables say about the rows they write.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "core/study/ordered_rows.h"

namespace drillwave {

/// How far a table has come, or got.
struct RowCounts {
    std::uint64_t rows = 0;    ///< written, without the header
    std::uint64_t failed = 0;  ///< of these, not solved: their output cells are empty
    RowsEnd end = RowsEnd::finished;
};

/// Takes the next bytes of the table; false stops the run (the disk is full, say).
using WriteText = std::function<bool(std::string_view)>;
/// Told now and then how far it is.
using RowProgress = std::function<void(const RowCounts&)>;

}  // namespace drillwave
