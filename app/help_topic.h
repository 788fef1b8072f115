// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of `drillwave help TOPIC`. A topic is a command, a place in the manual, a parameter, an output, a
// symbol, or another name in a table of the manual.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/text/handy_text.h"

namespace drillwave {

/// Returns the help on the topic that `words` name, in lines of at most `width` columns. It is in the
/// language of `style`; untranslated pages of the manual are in English. Throws CommandError (usage) with
/// similar names if there is no such topic. Requires at least one word.
std::string topicText(std::span<const std::string> words, std::size_t width,
                      const ReadingStyle& style = plainStyle());

/// Returns the keys of all parameters that --set accepts in every scenario, whether their values are numbers
/// or words.
std::vector<std::string> parameterNames();

/// Returns the names of all topics of `drillwave help`: commands, chapters of the manual, parameters and
/// outputs.
std::vector<std::string> topicNames();

}  // namespace drillwave
