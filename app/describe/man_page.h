// SPDX-License-Identifier: GPL-3.0-or-later
// The manual pages of the programs, in the language of man(7), from the help of the commands.
#pragma once

#include <string>
#include <string_view>

namespace drillwave {

/// drillwave(1): every command with all of its help. `date` is that of the page, "2026-11-25".
std::string manPage(std::string_view date);

/// drillwave-window(1), which leads there.
std::string windowManPage(std::string_view date);

/// Escapes a text so that it reads the same in a manual page; words between backquotes become bold.
std::string manText(std::string_view text);

/// Converts lines of a help: paragraphs are filled, "  word   what it means" becomes an item with its
/// meaning, and other indented lines stay as they are.
std::string manDetails(std::string_view lines);

}  // namespace drillwave
