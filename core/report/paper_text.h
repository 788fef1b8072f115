// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of any length on paper, which has room for so much of them. All of them are UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// The beginning of a text that fits on paper.
struct PaperLines {
    std::string text;     ///< broken where a line would be too long
    bool isWhole = true;  ///< nothing is left out
};

/// Returns the first `lines` lines of a text, broken at `columns` columns; a tab and the characters of wide
/// scripts take several columns.
PaperLines linesOnPaper(std::string_view text, std::size_t lines, std::size_t columns);

/// A text of one line for a cell of a table: what is wider than so many columns ends with "…", and words that
/// would widen a column of the table may be broken anywhere (U+200B).
std::string cellOnPaper(std::string_view text, std::size_t columns);

}  // namespace drillwave
