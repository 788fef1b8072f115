// SPDX-License-Identifier: GPL-3.0-or-later
// Languages of the program.
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
    /// ISO 639 code ("de"), as for the option `--language` and in resources/languages
    std::string_view code;
    std::string_view name;  ///< name of the language in that language ("Deutsch")
};

/// Languages of the program: English, in which all texts are written, and those with a complete catalogue of
/// translations.
inline constexpr Language languages[] = {{"en", "English"}, {"de", "Deutsch"}, {"sv", "Svenska"}};

/// Returns whether a language is English, which needs no catalogue. Requires an element of `languages`.
constexpr bool isEnglish(const Language& language) {
    return &language == &languages[0];
}

/// Returns the language with this ISO 639 code, or nullptr.
constexpr const Language* findLanguage(std::string_view code) {
    const auto* const found = std::ranges::find(languages, code, &Language::code);
    return found == std::end(languages) ? nullptr : found;
}

// Translations of the texts of core and commands, without Qt.

/// Returns the translation of an English text; the English text itself if there is no translation. The first
/// call for a language takes about 40 ms, as it reads the catalogue. Not thread-safe.
std::string inLanguage(const Language& language, const std::string& english);

/// Returns all translations into a language: the English text and its translation; empty for English. Not
/// thread-safe.
const std::map<std::string, std::string, std::less<>>& textsOf(const Language& language);

// Format of the commands' output in each language.

/// Returns the format of texts in a language: translated sentences, the decimal sign of the language, SI
/// units. For English it is plainStyle(). Not thread-safe.
const ReadingStyle& styleOf(const Language& language);

}  // namespace drillwave
