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

/// Column of a table of cases (a CSV file with one scenario per row), as described by its header cell.
struct CaseColumn {
    std::string text;  ///< header cell as written
    enum class Kind { parameter, word, other } kind = Kind::other;
    KeptParameter parameter = {};          ///< parameter that the column sets, for Kind::parameter
    const WordParameter* words = nullptr;  ///< word parameter that the column sets, for Kind::word
    /// Unit of numbers in the column that have no unit of their own, from a heading such as "rod.length
    /// [mm]". It is nullptr if the heading has no unit.
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
    /// Errors in the header, such as a parameter that occurs twice, an unknown unit, or no column that sets a
    /// parameter. A name that differs from a parameter only in case or `_` is also an error. The same is true
    /// of a name that looks like a misspelt parameter or contains several parameters.
    std::vector<HeaderRemark> problems;
    /// Warnings about columns that are only copied: those with an unknown name, and those with the heading of
    /// an output that is also computed.
    std::vector<HeaderRemark> warnings;

    /// Returns the parameters that the columns set, in the order of the columns.
    Assignments assignments() const;
};

/// Returns the header read from the first row of a table. `outputs` are the result columns that will be
/// appended. A column of the table with the same heading as one of them gets a warning.
TableHeader readTableHeader(std::span<const std::string> cells, std::span<const OutputColumn> outputs);

}  // namespace drillwave
