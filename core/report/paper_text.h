// SPDX-License-Identifier: GPL-3.0-or-later
// Fits texts of any length into the space available on paper. All texts are UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// Beginning of a text, as much as fits into a number of lines on paper.
struct PaperLines {
    std::string text;     ///< text with line breaks added where a line would be too long
    bool isWhole = true;  ///< whether the text is complete, with nothing omitted
};

/// Returns the first `lines` lines of a text, broken at `columns` columns. A tab and characters of wide
/// scripts take several columns.
PaperLines linesOnPaper(std::string_view text, std::size_t lines, std::size_t columns);

/// Returns a text of one line for a table cell. Text wider than `columns` columns is cut and ends with "…".
/// Words that would widen the column may be broken anywhere (marked by U+200B).
std::string cellOnPaper(std::string_view text, std::size_t columns);

}  // namespace drillwave
