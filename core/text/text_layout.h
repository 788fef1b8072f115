// SPDX-License-Identifier: GPL-3.0-or-later
// How a text stands in a terminal: its columns are characters, not bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// Characters of a text in UTF-8: columns of a terminal.
std::size_t columnsOf(std::string_view text);

/// The byte at which the character of that number begins, from 0; the length of a text that is not longer.
std::size_t byteOfColumn(std::string_view text, std::size_t column);

/// With blanks behind or before it up to so many columns; a wider one stays as it is.
std::string leftAligned(std::string_view text, std::size_t columns);
std::string rightAligned(std::string_view text, std::size_t columns);

/// Each line behind so many blanks, with a line feed at the end.
std::string indented(std::string_view lines, std::size_t blanks);

}  // namespace drillwave
