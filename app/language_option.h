// SPDX-License-Identifier: GPL-3.0-or-later
// The language that a command line asks for.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/text/languages.h"

namespace drillwave {

/// The option of every command, and of the window.
inline constexpr OptionSpec languageOption{"language", "CODE",
                                           "use German (de), Swedish (sv) or English (en)"};

/// Environment variable with the language of all commands.
inline constexpr const char* languageVariable = "DRILLWAVE_LANGUAGE";

/// Returns the language of the variable, "de" or "de_DE.UTF-8"; English where the variable names none.
const Language& languageOfEnvironment();

/// Throws CommandError (usage) where the variable is there and names no language.
void checkLanguageVariable();

/// Takes the option out of the words; nullptr without it. Throws CommandError (usage) if it names no language
/// or is given twice.
const Language* takeLanguage(std::vector<std::string>& words);

}  // namespace drillwave
