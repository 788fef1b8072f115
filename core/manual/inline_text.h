// SPDX-License-Identifier: GPL-3.0-or-later
// What stands inside a line of Markdown, and how it is broken into lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// A line without the marks of bold, slanted and links, whose words stay; code keeps its backquotes.
std::string withoutMarks(std::string_view line);

/// What stands between backquotes, in order.
std::vector<std::string_view> codeIn(std::string_view line);

/// Lines of at most so many columns, broken at blanks; a longer word has a line of its own. At least one
/// line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

}  // namespace drillwave
