// SPDX-License-Identifier: GPL-3.0-or-later
// Manual pages of the two programs in the markup of man(7), generated from the help of the commands.
#pragma once

#include <string>
#include <string_view>

namespace drillwave {

/// Returns the page drillwave(1), with the complete help of every command. `date` is printed on the page,
/// "2026-11-25".
std::string manPage(std::string_view date);

/// Returns the page drillwave-window(1), a short page that refers to drillwave(1). `date` is printed on the
/// page.
std::string windowManPage(std::string_view date);

/// Returns a text in the markup of man(7), escaped so that it reads the same; words between backquotes become
/// bold.
std::string manText(std::string_view text);

/// Returns lines of a help text in the markup of man(7). Lines without indent become filled paragraphs, a
/// line "  word   meaning" becomes a list item, and other indented lines stay as they are.
std::string manDetails(std::string_view lines);

}  // namespace drillwave
