// Numbers written into the rows of tables, without allocation.
#pragma once

#include <charconv>
#include <string>

namespace drillwave {

/// Appends the shortest text that reads back as the same double; nothing for NaN, which is an empty cell.
inline void appendNumber(std::string& row, double value) {
    if (value != value) return;
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    row.append(text, end.ptr);
}

}  // namespace drillwave
