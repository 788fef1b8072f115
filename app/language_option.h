// SPDX-License-Identifier: GPL-3.0-or-later
// The language that a command line asks for.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/text/languages.h"

namespace drillwave {

/// What every command takes, and the window.
inline constexpr OptionSpec languageOption{"language", "CODE",
                                           "speak German (de), Swedish (sv) or English (en)"};

/// The variable of the environment that says it for all commands.
inline constexpr const char* languageVariable = "DRILLWAVE_LANGUAGE";

/// The one of that code; an empty one is a missing word. Throws CommandError (usage) where there is none.
const Language& languageOf(const std::string& code);

/// That of the variable; English without. Throws CommandError (usage) where it names none.
const Language& languageOfEnvironment();

/// That of the option, which goes from the words, or `otherwise`. Throws CommandError (usage) where it names
/// none, and where it is there twice.
const Language& takeLanguage(std::vector<std::string>& words, const Language& otherwise);

}  // namespace drillwave
