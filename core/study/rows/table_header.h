// SPDX-License-Identifier: GPL-3.0-or-later
// Header of a table of cases: the meaning of its columns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/model/assignments.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

/// Column of a table of cases, as described by its header cell.
struct CaseColumn {
    std::string text;  ///< header cell as written
    enum class Kind { parameter, word, other } kind = Kind::other;
    KeptParameter parameter = {};          ///< parameter that the column sets, for Kind::parameter
    const WordParameter* words = nullptr;  ///< word parameter that the column sets, for Kind::word
    /// Unit of cells that have none, from a heading such as "rod.length [mm]"; may be nullptr.
    const Unit* unit = nullptr;

    /// Returns the key of the parameter that the column sets. Empty for other columns, which are copied
    /// unchanged.
    std::string_view key() const;
};

/// Message about one column, numbered from 1; 0 stands for the header as a whole.
struct HeaderRemark {
    std::size_t column = 0;
    Message text;
};

/// Columns of a table in the order of the file, with problems and warnings about them.
struct TableHeader {
    std::vector<CaseColumn> columns;
    /// Errors in the header: no column sets a parameter, a parameter occurs twice, a unit is unknown, or
    /// bytes are not text. Also names that look like parameters but are not, differ from one only in case or
    /// `_`, or contain several.
    std::vector<HeaderRemark> problems;
    /// Warnings about columns that name neither a parameter nor an output, or that repeat an output that is
    /// appended.
    std::vector<HeaderRemark> warnings;

    /// Returns the parameters that the columns set, in the order of the columns.
    Assignments assignments() const;
};

/// Returns the header read from the first row of a table. `outputs` are the columns that will be appended.
TableHeader readTableHeader(std::span<const std::string> cells, std::span<const OutputColumn> outputs);

}  // namespace drillwave
