// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the core and the commands in the languages of the program, where there is no Qt to say them.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "core/text/languages.h"

namespace drillwave {

/// What the catalogue of the language has for an English text; the text itself in English, and where it has
/// none. The first text of a language reads its catalogue, which takes some 40 ms. Not for several threads.
std::string inLanguage(const Language& language, const std::string& english);

/// All English texts of that catalogue, each with what it has for it; none of English. Read likewise.
const std::map<std::string, std::string, std::less<>>& textsOf(const Language& language);

}  // namespace drillwave
