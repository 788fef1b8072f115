// SPDX-License-Identifier: GPL-3.0-or-later
// A table of cases solved row by row.
#pragma once

#include <cstdint>
#include <istream>
#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/row_counts.h"
#include "core/study/rows/row_sink.h"
#include "core/study/rows/shard.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

/// Settings for every row: its cells set the parameters that the header names, on top of `base`; an empty
/// cell leaves the value of `base`.
struct Table {
    Scenario base;
    std::string source;  ///< name of the file, for messages
    std::vector<OutputColumn> columns;
    Shard shard;
    std::uint64_t done = 0;  ///< rows of the part that are there already and are left out
    MethodChoice method = {};
    long workLimit = defaultWorkLimit;  ///< maximum wave pieces of a row; with more, it is not solved
};

/// Check of a table before anything is computed.
struct TableCheck {
    std::uint64_t rows = 0;
    std::vector<Message> problems;  ///< "cases.csv:7:3: bit_rock.gamma = 1.3 (…)", the first twenty
    std::vector<Message> warnings;  ///< "cases.csv:1: column 4 …"
    WorkEnd end = WorkEnd::finished;
};

/// Reads `cases`, which can be rewound and must be afterwards, and checks every cell of every row of the
/// part; other rows are only counted.
TableCheck checkTable(const Table& table, std::istream& cases, int jobs, std::stop_token stop);

/// Passes the rows to the sink in order: the cells of `cases` as unchanged text, and the outputs as numbers;
/// `rows` is the count of checkTable(). `progress` is called on the calling thread. Memory does not grow with
/// the number of rows; the rows do not depend on `jobs` (≥ 1). A row that has become invalid since the check
/// counts as failed.
RowCounts runTable(const Table& table, std::istream& cases, std::uint64_t rows, int jobs,
                   std::stop_token stop, RowSink& sink, const RowProgress& progress);

}  // namespace drillwave
