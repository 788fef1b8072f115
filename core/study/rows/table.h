// SPDX-License-Identifier: GPL-3.0-or-later
// Table of cases, solved row by row.
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

/// Settings of a table of cases, a CSV file with one scenario per row. The cells of a row set the parameters
/// named in the header, on top of `base`; an empty cell keeps the value of `base`.
struct Table {
    Scenario base;
    std::string source;  ///< name of the file, for messages
    std::vector<OutputColumn> columns;
    Shard shard;
    std::uint64_t done = 0;  ///< number of rows that an earlier run has already computed; they are skipped
    MethodChoice method = {};
    /// Maximum work of one row, in wave pieces (the solver's unit of work). Rows that need more are not
    /// solved.
    long workLimit = defaultWorkLimit;
};

/// Result of checking a table before anything is computed.
struct TableCheck {
    std::uint64_t rows = 0;
    /// First twenty problems with their positions, such as "cases.csv:7:3: bit_rock.gamma = 1.3 (…)".
    std::vector<Message> problems;
    std::vector<Message> warnings;  ///< warnings with their positions, such as "cases.csv:1: column 4 …"
    WorkEnd end = WorkEnd::finished;
};

/// Checks a table before it is solved. Returns its number of rows and the problems in them. Checks every
/// cell of the rows in Table::shard, which are to be solved; other rows are only counted. `cases` must be
/// seekable. The caller must rewind it before runTable().
TableCheck checkTable(const Table& table, std::istream& cases, int jobs, std::stop_token stop);

/// Solves the rows of a table and passes the result rows in order to `sink`, such as a CSV file. Returns how
/// many rows were completed and how many of them failed. Each row has the cells of `cases` as unchanged
/// text, then the outputs as numbers. `rows` is the count from checkTable(). `progress` is called on the
/// calling thread. Memory does not grow with the number of rows. The rows do not depend on the number of
/// threads `jobs` (≥ 1). A row that became invalid after the check counts as failed.
RowCounts runTable(const Table& table, std::istream& cases, std::uint64_t rows, int jobs,
                   std::stop_token stop, RowSink& sink, const RowProgress& progress);

}  // namespace drillwave
