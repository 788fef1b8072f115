// SPDX-License-Identifier: GPL-3.0-or-later
// The Markdown of the manual as blocks: headings, paragraphs, items of lists, code and tables.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

// Parts of a line of Markdown, and line breaks.

/// Returns a line without the marks of bold, slanted and links; code keeps its backquotes.
std::string withoutMarks(std::string_view line);

/// Returns the texts between backquotes, in order.
std::vector<std::string_view> codeIn(std::string_view line);

/// Returns lines of at most that many columns, broken at blanks; a longer word has a line of its own. At
/// least one line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// Lines that belong together.
struct ManualBlock {
    enum class Kind { heading, paragraph, item, code, table };
    Kind kind = Kind::paragraph;
    int level = 0;     ///< of a heading, from 1; else how many blanks it is indented by
    std::string mark;  ///< of an item: "-" or "3."
    std::string text;  ///< one line with its marks; of code the lines as they stand; of a table none
    std::vector<std::vector<std::string>> rows =
        {};  ///< of a table, its header first; each with as many cells
};

/// The blocks of a text, in order.
std::vector<ManualBlock> readMarkdown(std::string_view text);

/// Returns the blocks of a section from its heading to the next heading of the same or a higher level; none
/// if the heading is not found. `heading` is the number of the heading, "§3.1", or its whole text.
std::vector<ManualBlock> sectionOf(std::span<const ManualBlock> blocks, std::string_view heading);

/// "§3.1" of the heading "§3.1 Everything else"; empty where it has no number.
std::string_view sectionNumber(std::string_view heading);

}  // namespace drillwave
