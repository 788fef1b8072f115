// SPDX-License-Identifier: GPL-3.0-or-later
// Alignment and indentation of text in a terminal, where columns are characters, not bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// Returns the number of characters of a text in UTF-8, which is its width in columns of a terminal.
std::size_t columnsOf(std::string_view text);

/// Returns the byte offset of the character with number `column`, counted from 0. If the text has fewer
/// characters, returns its length in bytes.
std::size_t byteOfColumn(std::string_view text, std::size_t column);

/// Returns the text with blanks after it, or before it for rightAligned(), to fill this many columns. A text
/// that is wider does not change.
std::string leftAligned(std::string_view text, std::size_t columns);
std::string rightAligned(std::string_view text, std::size_t columns);

/// Returns the lines, each with this many blanks before it and a line feed at its end.
std::string indented(std::string_view lines, std::size_t blanks);

}  // namespace drillwave
