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
    bool isNumeric = false;  ///< most of its first cells are numbers
    bool isStamp = false;    ///< most of its first cells are times of day or dates with one
    bool isIndex = false;    ///< its first cells count on by one
    bool operator==(const TableColumn&) const = default;
};

/// "time [us]", "Time (us)", "t / us", "t/us", "t in us", "t us", "t, us", "time_us" in their parts, and "F
/// [kN] filtered", where the last brackets with a unit that is known stand inside. What stands in brackets at
/// the end, behind " / " or behind " in " is a unit, known or not; the others need one that is known.
TableColumn columnOf(std::string_view heading);

/// Whether a word is a unit of time or of a signal.
bool isKnownUnit(std::string_view word);

/// Whether a column of this name holds times: "t", "Time", "Zeit".
bool isTimeName(std::string_view name);

}  // namespace drillwave
