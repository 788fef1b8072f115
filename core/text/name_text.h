// SPDX-License-Identifier: GPL-3.0-or-later
// Names that people read in one line of a list, a message or a file.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

// Words that are alike but for capitals.

/// Returns A to Z as small letters, in any locale; other characters stay.
inline std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

/// Why a text cannot stand in one line: "must be one line", "must be UTF-8". It must be UTF-8 without control
/// characters and without those that turn the direction in which others are read. Empty when it can.
Message lineProblem(std::string_view text);

/// Why a text cannot be a name or the source of a value: lineProblem(), or "must have a letter". Empty when
/// it can.
Message nameProblem(std::string_view text);

/// The text as it can be printed in a message: what is not UTF-8, control characters and those that turn the
/// direction of reading are written as "\xE9" and "\u202E".
std::string printable(std::string_view text);

/// Returns the same for a text of several lines: line feeds and tabs stay.
std::string printableLines(std::string_view text);

/// Returns the same for a title, which is one line: line feeds and tabs become blanks.
std::string printableLine(std::string_view text);

// "Did you mean …?" for mistyped names.

/// The candidate within a few typing errors of `name` (insertions, deletions, replacements, swapped
/// neighbours; about one in three characters), or empty when none is that close. Also finds "stiffness" for
/// "bit_rock.stiffness".
std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

/// The shortest candidate that has all words of `name`, "drill_penetration_rate" for "drilling_rate", or
/// empty. Words are the parts between underscores; the longer of two may go on.
std::string_view nameWithWords(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace drillwave
