// What the header of a table of cases says about its columns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/model/parameter.h"

namespace drillwave {

/// One column of a table of cases.
struct TableColumn {
    std::string text;  ///< header cell as written
    enum class Kind { parameter, shape, other } kind = Kind::other;
    const Parameter* parameter = nullptr;  ///< Kind::parameter
    const Unit* unit = nullptr;            ///< of cells without one, from "rod.length [mm]"; may be nullptr

    std::string_view key() const;  ///< empty for other columns, which are passed through
};

/// The columns in the order of the file.
struct TableHeader {
    std::vector<TableColumn> columns;
    std::vector<std::string> problems;  ///< a parameter named twice, an unknown unit
    std::vector<std::string> warnings;  ///< columns that name neither a parameter nor an output

    /// The columns that set something, in the order in which a row sets them: the shape, physical parameters,
    /// groups.
    std::vector<std::size_t> assignmentOrder() const;
};

TableHeader readTableHeader(std::span<const std::string> cells);

}  // namespace drillwave
