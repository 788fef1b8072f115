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
                                           "use German (de), Swedish (sv) or English (en)"};

/// The variable of the environment that says it for all commands.
inline constexpr const char* languageVariable = "DRILLWAVE_LANGUAGE";

/// Returns the language of the variable, "de" or "de_DE.UTF-8"; English where the variable names none.
const Language& languageOfEnvironment();

/// Throws CommandError (usage) where the variable is there and names no language.
void checkLanguageVariable();

/// That of the option, which goes from the words; nullptr without. Throws CommandError (usage) where it names
/// none, and where it is there twice.
const Language* takeLanguage(std::vector<std::string>& words);

}  // namespace drillwave
