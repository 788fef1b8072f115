// SPDX-License-Identifier: GPL-3.0-or-later
// Language of the output, given by --language or an environment variable.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/text/languages.h"

namespace drillwave {

/// Description of the option --language, which every command and the window accept.
inline constexpr OptionSpec languageOption{"language", "CODE",
                                           "use German (de), Swedish (sv) or English (en)"};

/// Environment variable that sets the language of all commands.
inline constexpr const char* languageVariable = "DRILLWAVE_LANGUAGE";

/// Returns the language given by the environment variable as "de" or "de_DE.UTF-8"; English if the variable
/// is unset or names no known language.
const Language& languageOfEnvironment();

/// Throws CommandError (usage) if the environment variable is set but names no known language.
void checkLanguageVariable();

/// Removes --language and its value from `words` and returns the language, or nullptr without the option.
/// Throws CommandError (usage) if the language is unknown or the option is given twice.
const Language* takeLanguage(std::vector<std::string>& words);

}  // namespace drillwave
