// SPDX-License-Identifier: GPL-3.0-or-later
// Markdown of the manual as blocks: headings, paragraphs, list items, code and tables.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

// Parts of a line of Markdown, and line breaks.

/// Returns a line without the marks for bold, italics and links. Code keeps its backquotes.
std::string withoutMarks(std::string_view line);

/// Returns the texts between backquotes in a line, in order.
std::vector<std::string_view> codeIn(std::string_view line);

/// Returns the text as lines of at most `width` columns, broken at blanks. A word that is longer has a line
/// of its own. An empty text gives one empty line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// Block of Markdown: lines that belong together, such as a paragraph or a table.
struct ManualBlock {
    enum class Kind { heading, paragraph, item, code, table };
    Kind kind = Kind::paragraph;
    /// Level of a heading, from 1. For other kinds of block it is the indentation, in blanks.
    int level = 0;
    std::string mark;  ///< mark of a list item, "-" or "3."
    /// Text of the block in one line, including the Markdown of bold, italics and links. For code, the
    /// unchanged lines; for a table, empty.
    std::string text;
    /// Rows of a table, the header first, all with the same number of cells.
    std::vector<std::vector<std::string>> rows = {};
};

/// Returns the blocks of a Markdown text, in order.
std::vector<ManualBlock> readMarkdown(std::string_view text);

/// Returns the blocks of a section, from its heading to the next heading of the same or a higher level. The
/// section is given by the number of its heading, "§3.1", or by the complete text of the heading. Returns
/// none if the heading is not found.
std::vector<ManualBlock> sectionOf(std::span<const ManualBlock> blocks, std::string_view heading);

/// Returns the number of a heading, "§3.1" for "§3.1 Everything else"; empty if it has none.
std::string_view sectionNumber(std::string_view heading);

}  // namespace drillwave
