// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of `drillwave help TOPIC` for a command, a chapter of the manual or a section of it, a parameter,
// an output, a symbol, or anything else that a table of the manual names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/text/handy_text.h"

namespace drillwave {

/// The text of the topic that these words name, in lines of at most `width` columns: of a command in the
/// language of the style, of what the manual has in English. Throws CommandError (usage) with the nearest
/// names where there is none. Requires a word.
std::string topicText(std::span<const std::string> words, std::size_t width,
                      const ReadingStyle& style = plainStyle());

/// The keys of numbers and words that every scenario may have, which --set takes.
std::vector<std::string> parameterNames();

/// Returns all names: commands, chapters, parameters, outputs.
std::vector<std::string> topicNames();

}  // namespace drillwave
