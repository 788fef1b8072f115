// SPDX-License-Identifier: GPL-3.0-or-later
// The languages that the window speaks.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

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

}  // namespace drillwave
