// SPDX-License-Identifier: GPL-3.0-or-later
// Text and tables as HTML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// A text as it stands between the tags of HTML, SVG and XML, or in a quoted attribute: printableLines(), and
/// nothing of it is markup.
std::string escapedHtml(std::string_view text);

/// "<TAG>text</TAG>", the text escaped.
std::string htmlElement(std::string_view tag, std::string_view text);

/// The head of a column; a word is not broken.
std::string htmlHead(std::string_view text);

/// The line that names the columns of a table, which paper has again on every page.
std::string htmlHeads(const std::vector<std::string>& names);

/// Lines of a table, the first of which names the columns; in the others a number stays with what is beside
/// it.
std::string htmlRows(const std::vector<std::vector<std::string>>& rows);

}  // namespace drillwave
