// SPDX-License-Identifier: GPL-3.0-or-later
// Fits texts of any length into the space available on paper. All texts are UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// Beginning of a text that fits into a given number of lines on paper.
struct PaperLines {
    std::string text;     ///< text with line breaks added where a line would be too long
    bool isWhole = true;  ///< whether the text is complete, with nothing omitted
};

/// Returns the first `lines` lines of a text. Longer lines are broken after `columns` columns. A tab and wide
/// characters (such as Chinese ones) take several columns.
PaperLines linesOnPaper(std::string_view text, std::size_t lines, std::size_t columns);

/// Returns a text in one line, for a table cell. A text wider than `columns` columns is cut and ends with
/// "…". Long words are marked (by U+200B) so that they may be broken anywhere.
std::string cellOnPaper(std::string_view text, std::size_t columns);

}  // namespace drillwave
