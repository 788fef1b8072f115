// SPDX-License-Identifier: GPL-3.0-or-later
// Names of one line, as in lists, messages and files: rules for their characters, and suggestions for
// mistyped ones.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

// Comparison that ignores capitals.

/// Returns the text with A to Z as small letters, in any locale; other characters do not change.
inline std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

/// Returns why a text is not allowed in one line: "must be one line", "must be UTF-8"; empty if it is
/// allowed. Control characters and characters that change the reading direction are not allowed.
Message lineProblem(std::string_view text);

/// Returns why a text is not allowed as a name, or as the reference from which a value was taken. Empty if it
/// is allowed. It must pass lineProblem() and have a letter.
Message nameProblem(std::string_view text);

/// Returns the text with everything unprintable escaped, as "\xE9" or "\u202E", for messages. This concerns
/// bytes that are not UTF-8, control characters and characters that change the reading direction.
std::string printable(std::string_view text);

/// Returns a text of several lines with everything unprintable escaped, as "\xE9"; line feeds and tabs
/// remain.
std::string printableLines(std::string_view text);

/// Returns a title as one line with everything unprintable escaped, as "\xE9"; line feeds and tabs become
/// blanks.
std::string printableLine(std::string_view text);

// Suggestions for mistyped names: "Did you mean …?"

/// Returns the candidate with the fewest typing errors against `name`, at most one per three characters;
/// empty if there is none. Errors are inserted, missing, replaced and swapped characters. "stiffness" also
/// finds "bit_rock.stiffness".
std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

/// Returns the shortest candidate that has all words of `name`, or empty: "drilling_rate" finds
/// "drill_penetration_rate". Words are the parts between underscores. Two words match if one begins with the
/// other; both must have at least four letters.
std::string_view nameWithWords(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace drillwave
