// SPDX-License-Identifier: GPL-3.0-or-later
// Converts text and tables to HTML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// Returns a text escaped for use between tags of HTML, SVG or XML, or in a quoted attribute. Applies
/// printableLines() first; the result contains no markup.
std::string escapedHtml(std::string_view text);

/// Returns "<TAG>text</TAG>" with the text escaped.
std::string htmlElement(std::string_view tag, std::string_view text);

/// Returns the header cell of a table column; a single word is not broken across lines.
std::string htmlHead(std::string_view text);

/// Returns the header line of a table, which is repeated on every printed page.
std::string htmlHeads(const std::vector<std::string>& names);

/// Returns the rows of an HTML table; the first of `rows` has the headings. In all other rows, a number and
/// its unit are kept on one line.
std::string htmlRows(const std::vector<std::vector<std::string>>& rows);

}  // namespace drillwave
