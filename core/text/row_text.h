// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers written into the rows of tables, without allocation.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

namespace drillwave {

/// Appends the shortest text that reads back as the same double; nothing, an empty cell, where there is no
/// finite number.
inline void appendNumber(std::string& row, double value) {
    if (!std::isfinite(value)) return;
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    row.append(text, end.ptr);
}

}  // namespace drillwave
