// SPDX-License-Identifier: GPL-3.0-or-later
// The languages that the window speaks.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

#include "core/text/handy_text.h"

namespace drillwave {

struct Language {
    std::string_view code;  ///< ISO 639, as for `--language` and in resources/languages
    std::string_view name;  ///< as its speakers call it
};

/// English, which the texts are written in, and those with a whole catalogue.
inline constexpr Language languages[] = {{"en", "English"}, {"de", "Deutsch"}, {"sv", "Svenska"}};

/// Whether it is the first of them, which needs no catalogue.
constexpr bool isEnglish(const Language& language) {
    return &language == &languages[0];
}

/// The language of that code, or nullptr.
constexpr const Language* findLanguage(std::string_view code) {
    const auto* const found = std::ranges::find(languages, code, &Language::code);
    return found == std::end(languages) ? nullptr : found;
}

// Texts of the core and the commands in the languages of the program, without Qt.

/// Returns the translation of an English text in the catalogue of the language; the text itself for English
/// or without a translation. The first text of a language reads its catalogue in some 40 ms. Not thread-safe.
std::string inLanguage(const Language& language, const std::string& english);

/// Returns all English texts of that catalogue with their translations; none for English. Not thread-safe.
const std::map<std::string, std::string, std::less<>>& textsOf(const Language& language);

// The style of the commands in each of the languages.

/// Returns the style of a language: sentences from its catalogue, numbers with its decimal sign, units in SI;
/// for English, plainStyle(). Not thread-safe.
const ReadingStyle& styleOf(const Language& language);

}  // namespace drillwave
