// SPDX-License-Identifier: GPL-3.0-or-later
// Text as it is checked before anything interprets it: UTF-8, and where a byte of it is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drillwave {

/// The first byte at which the text is not UTF-8 text (NUL, control characters, malformed sequences, lone
/// CR).
struct TextProblem {
    std::size_t offset = 0;
    std::string reason;  ///< empty when the text is fine
};
TextProblem checkText(std::string_view text);

/// How many of the first bytes are UTF-8, control characters included.
std::size_t utf8Length(std::string_view text);
/// Whether all bytes are.
bool isUtf8(std::string_view text);

/// 3 for a text that begins with the UTF-8 byte order mark, else 0.
std::size_t byteOrderMarkLength(std::string_view text);

/// Line and column of a byte, both from 1; a column is a character.
struct TextPosition {
    int line = 1;
    int column = 1;
};

/// Returns the position of a byte of the text. Walks through the text: only for messages.
TextPosition positionOf(std::string_view text, std::size_t offset);

}  // namespace drillwave
