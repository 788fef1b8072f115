// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of text before it is parsed: whether it is UTF-8, and the line and column of a byte.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// First fault of a text, at the byte `offset`: not UTF-8, NUL, a control character, or a carriage return
/// without a line feed.
struct TextProblem {
    std::size_t offset = 0;
    std::string reason;  ///< description of the fault, "a NUL byte"; empty if the text has none
};
/// Returns the first byte that is not allowed in a text file; an empty `reason` if there is none.
TextProblem checkText(std::string_view text);

/// Returns the number of bytes at the beginning that are valid UTF-8, including control characters.
std::size_t utf8Length(std::string_view text);
/// Returns whether the entire text is valid UTF-8; control characters are allowed.
bool isUtf8(std::string_view text);

/// Returns the length of the UTF-8 byte order mark at the beginning of the text: 3 bytes, or 0 if there is
/// none.
std::size_t byteOrderMarkLength(std::string_view text);

/// Line and column of a byte of a text, both counted from 1. Columns count characters, not bytes.
struct TextPosition {
    int line = 1;
    int column = 1;
};

/// Returns line and column of the byte at `offset`, not counting a byte order mark. Reads the text from its
/// start, so it is only for messages.
TextPosition positionOf(std::string_view text, std::size_t offset);

}  // namespace drillwave
