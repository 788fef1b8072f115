// SPDX-License-Identifier: GPL-3.0-or-later
// Header of a table of cases: the contents of its columns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/model/assignments.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

/// Column of a table of cases.
struct CaseColumn {
    std::string text;  ///< header cell as written
    enum class Kind { parameter, word, other } kind = Kind::other;
    KeptParameter parameter = {};          ///< Kind::parameter
    const WordParameter* words = nullptr;  ///< Kind::word
    const Unit* unit = nullptr;            ///< of cells without one, from "rod.length [mm]"; may be nullptr

    std::string_view key() const;  ///< empty for other columns, which are passed through
};

/// Something about a column, counted from 1; 0 is the header as a whole.
struct HeaderRemark {
    std::size_t column = 0;
    Message text;
};

/// The columns in the order of the file.
struct TableHeader {
    std::vector<CaseColumn> columns;
    /// No column sets anything; a name that begins as those of parameters and is none; one that only case,
    /// `_` or the like keeps from being a parameter, or that holds several; a parameter named twice, an
    /// unknown unit; bytes that are no text.
    std::vector<HeaderRemark> problems;
    /// Columns that name neither a parameter nor an output, or an output that is appended as well.
    std::vector<HeaderRemark> warnings;

    /// Returns the parameters that the columns set, numbered like the columns.
    Assignments assignments() const;
};

/// Reads a header; `outputs` are those that are appended.
TableHeader readTableHeader(std::span<const std::string> cells, std::span<const OutputColumn> outputs);

}  // namespace drillwave
