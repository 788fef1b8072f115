// SPDX-License-Identifier: GPL-3.0-or-later
// Names that people read in one line of a list, a message or a file.
#pragma once

#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Why a text cannot stand in one line: "must be one line", "must be UTF-8". It must be UTF-8 without control
/// characters and without those that turn the direction in which others are read. Empty when it can.
Message lineProblem(std::string_view text);

/// Why a text cannot be a name or the source of a value: lineProblem(), or "must have a letter". Empty when
/// it can.
Message nameProblem(std::string_view text);

/// The text as it can be printed in a message: what is not UTF-8, control characters and those that turn the
/// direction of reading are written as "\xE9" and "\u202E".
std::string printable(std::string_view text);

/// The same for a text of several lines: line feeds and tabs stay.
std::string printableLines(std::string_view text);

/// The same for a title, which is one line: line feeds and tabs become blanks.
std::string printableLine(std::string_view text);

}  // namespace drillwave
