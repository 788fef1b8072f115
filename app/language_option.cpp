// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language_option.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "app/command_error.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

std::string variableWord() {
    const char* variable = std::getenv(languageVariable);
    return variable ? variable : "";
}

/// Returns the language of "de", "DE", or of a locale as systems write it, "de_DE.UTF-8"; else nullptr.
const Language* languageOfLocale(const std::string& word) {
    return findLanguage(lowerCase(word.substr(0, word.find_first_of("_-.@"))));
}

const Language* languageNamed(const std::string& code, const std::string& by) {
    if (const Language* found = languageOfLocale(code)) return found;
    std::string known;
    for (const Language& language : languages)
        known += (known.empty() ? "" : ", ") + std::string(language.code);
    if (code.empty())
        throw CommandError(ExitCode::usage, Message(translatable("%1 needs one of %2"), {by, known}));
    throw CommandError(ExitCode::usage,
                       Message(translatable("%1: `%2` is not one of %3"), {by, shortened(code), known}));
}

}  // namespace

const Language& languageOfEnvironment() {
    const Language* found = languageOfLocale(variableWord());
    return found ? *found : languages[0];
}

void checkLanguageVariable() {
    if (const std::string word = variableWord(); !word.empty()) languageNamed(word, languageVariable);
}

const Language* takeLanguage(std::vector<std::string>& words) {
    const std::string name = languageOption.text();
    std::optional<std::string> code;
    const auto end = [&] { return std::ranges::find(words, "--"); };
    const auto isIt = [&](const std::string& word) { return word == name || word.starts_with(name + "="); };
    for (auto word = std::find_if(words.begin(), end(), isIt); word != end();
         word = std::find_if(words.begin(), end(), isIt)) {
        if (code)
            throw CommandError(ExitCode::usage,
                               Message(translatable("`%1` is given twice; give it once"), {name}));
        if (*word != name) {
            code = word->substr(name.size() + 1);
            words.erase(word);
            continue;
        }
        const bool hasCode = std::next(word) != words.end();
        code = hasCode ? *std::next(word) : std::string();
        words.erase(word, std::next(word, hasCode ? 2 : 1));
    }
    return code ? languageNamed(*code, name) : nullptr;
}

}  // namespace drillwave
