// SPDX-License-Identifier: GPL-3.0-or-later
// What the cell above a column of samples says of it.
#pragma once

#include <string>
#include <string_view>

namespace drillwave {

/// One column; name and unit are empty where no header gives them.
struct TableColumn {
    std::string name;
    std::string unit;
    bool isNumeric = false;  ///< its first cells are numbers
    bool operator==(const TableColumn&) const = default;
};

/// "time [us]", "Time (us)", "t / us", "t/us", "t in us", "t us", "time_us" in their parts. What stands in
/// brackets, behind " / " or behind " in " is a unit, known or not; the others need one that is known.
TableColumn columnOf(std::string_view heading);

/// Whether a column of this name holds times: "t", "Time", "Zeit".
bool isTimeName(std::string_view name);

}  // namespace drillwave
