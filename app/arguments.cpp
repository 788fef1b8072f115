// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/arguments.h"

#include <algorithm>
#include <array>

#include "app/command_error.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

[[noreturn]] void refuse(const Message& line) {
    throw CommandError(ExitCode::usage, line);
}

/// A word that begins like an option, in its parts.
struct OptionWord {
    std::string_view name;
    std::optional<std::string> value;  ///< attached: --name=value, -j4
};

OptionWord split(std::string_view word) {
    if (!word.starts_with("--")) {
        OptionWord option{word.substr(1, 1), std::nullopt};
        if (word.size() > 2) option.value = std::string(word.substr(word[2] == '=' ? 3 : 2));
        return option;
    }
    const std::size_t equals = word.find('=');
    OptionWord option{word.substr(2, equals == std::string_view::npos ? equals : equals - 2), std::nullopt};
    if (equals != std::string_view::npos) option.value = std::string(word.substr(equals + 1));
    return option;
}

/// Names of options in other programs.
constexpr auto otherNames = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"jobs", "j"},
    {"threads", "j"},
    {"parallel", "j"},
    {"out", "o"},
    {"output", "o"},
    {"output-dir", "o"},
    {"overwrite", "force"},
    {"format", "json"},
    {"param", "set"},
    {"axis", "vary"},
});

/// Two names of one option: each command has the one that fits the number of outputs it takes.
constexpr auto sameNames = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"output", "outputs"},
    {"outputs", "output"},
});

/// The option most like an unknown long one; nothing is like a single letter.
const OptionSpec* nearestOption(std::string_view name, std::span<const OptionSpec> options) {
    std::vector<std::string_view> names;
    for (const OptionSpec& option : options)
        if (option.isLong()) names.push_back(option.name);
    const auto other =
        std::ranges::find(otherNames, name, &std::pair<std::string_view, std::string_view>::first);
    const std::string_view near = other != otherNames.end() ? other->second : nearestName(name, names);
    const auto found = std::ranges::find(options, near, &OptionSpec::name);
    return found == options.end() ? nullptr : &*found;
}

[[noreturn]] void refuseUnknown(std::string_view word, std::string_view name,
                                std::span<const OptionSpec> options) {
    const OptionSpec* nearest = word.starts_with("--") ? nearestOption(name, options) : nullptr;
    if (nearest)
        refuse({translatable("unknown option `%1`; did you mean `%2`?"), {shortened(word), nearest->text()}});
    refuse({translatable("unknown option `%1`; --help lists the options"), {shortened(word)}});
}

/// Quoted where a shell would read more into it than the word.
std::string shellWord(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%^";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

bool isOption(std::string_view word) {
    return word.size() > 1 && word.starts_with('-');
}

/// The one that a word names, if any.
const OptionSpec* optionNamed(const OptionWord& given, const std::string& word,
                              std::span<const OptionSpec> options) {
    const auto find = [&](std::string_view name) {
        const auto option = std::ranges::find(options, name, &OptionSpec::name);
        return option == options.end() || option->isLong() != word.starts_with("--") ? nullptr : &*option;
    };
    if (const OptionSpec* option = find(given.name)) return option;
    for (const auto& [name, other] : sameNames)
        if (name == given.name) return find(other);
    return nullptr;
}

/// Returns the word after an option with a value. An option of the command is none: the value is missing.
const std::string& valueBehind(const OptionSpec& option, std::span<const std::string> rest,
                               std::span<const OptionSpec> options) {
    const Message needs{translatable("`%1` needs a value: %2"), {option.text(), std::string(option.value)}};
    if (rest.empty()) refuse(needs);
    const std::string& word = rest.front();
    if (word != "--" && !(isOption(word) && optionNamed(split(word), word, options))) return word;
    if (option.name == "o")
        refuse({translatable("%1; `%2` after it is an option; write ./%2 for a file of that name"),
                {needs, shortened(word)}});
    refuse({translatable("%1; `%2` after it is an option"), {needs, shortened(word)}});
}

void addWord(std::string& text, const std::string& word) {
    text += (text.empty() ? "" : " ") + shellWord(word);
}

}  // namespace

bool OptionSpec::isLong() const {
    return name.size() > 1 || name == "x" || name == "y";
}

std::string OptionSpec::text() const {
    return (isLong() ? "--" : "-") + std::string(name);
}

Arguments Arguments::parse(std::span<const std::string> words, std::span<const OptionSpec> options) {
    Arguments arguments;
    bool optionsEnded = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (optionsEnded || !isOption(word)) {
            arguments.m_operands.push_back(word);
            continue;
        }
        if (word == "--") {
            optionsEnded = true;
            continue;
        }
        OptionWord given = split(word);
        const OptionSpec* option = optionNamed(given, word, options);
        if (!option) refuseUnknown(word, given.name, options);
        if (option->times == OptionSpec::Times::once && arguments.has(option->name))
            refuse({translatable("`%1` is given twice; give it once"), {option->text()}});
        if (option->value.empty()) {
            if (given.value) refuse({translatable("`%1` takes no value"), {option->text()}});
            given.value = "";
            arguments.m_switches.push_back(option->name);
        } else if (!given.value) {
            given.value = valueBehind(*option, words.subspan(++i), options);
        }
        arguments.m_options.emplace_back(option->name, *given.value);
        if (!option->sets.empty()) arguments.m_shorts.emplace_back(option->sets, option->name);
        if (option->times != OptionSpec::Times::list) continue;
        while (i + 1 < words.size() && !isOption(words[i + 1]) && words[i + 1].find('=') != std::string::npos)
            arguments.m_options.emplace_back(option->name, words[++i]);
    }
    return arguments;
}

bool Arguments::has(std::string_view option) const {
    return value(option).has_value();
}

std::optional<std::string> Arguments::value(std::string_view option) const {
    for (const auto& [name, value] : m_options)
        if (name == option) return value;
    return std::nullopt;
}

std::vector<std::string> Arguments::values(std::string_view option) const {
    std::vector<std::string> found;
    for (const auto& [name, value] : m_options)
        if (name == option) found.push_back(value);
    return found;
}

void Arguments::replaceValue(std::string_view option, std::string value) {
    std::ranges::find(m_options, option, &std::pair<std::string_view, std::string>::first)->second =
        std::move(value);
}

std::vector<std::string> Arguments::listed(std::string_view option, std::span<const std::string_view> known,
                                           const char* pattern) const {
    const std::optional<std::string> list = value(option);
    if (!list) return {};
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= list->size();) {
        const std::size_t end = std::min(list->find(',', begin), list->size());
        const std::string word = list->substr(begin, end - begin);
        begin = end + 1;
        if (std::ranges::find(known, word) == known.end()) {
            std::string choices;
            for (const std::string_view each : known)
                choices += (choices.empty() ? "" : ", ") + std::string(each);
            refuse({pattern, {shortened(*list), word, choices}});
        }
        if (std::ranges::find(words, word) == words.end()) words.push_back(word);
    }
    return words;
}

void Arguments::checkOnePrinted() const {
    if (has("json") && value("o") == "-")
        refuse({translatable("--json and -o - would both print to standard output; take one")});
}

std::string Arguments::optionsText(std::span<const std::string_view> without) const {
    std::string text;
    for (const auto& [name, value] : m_options) {
        if (std::ranges::find(without, name) != without.end()) continue;
        addWord(text, OptionSpec{name, {}, {}}.text());
        if (std::ranges::find(m_switches, name) == m_switches.end()) addWord(text, value);
    }
    return text;
}

std::string Arguments::shellText(std::span<const std::string_view> without) const {
    const std::string options = optionsText(without);
    std::string operands;
    for (const std::string& operand : m_operands) addWord(operands, operand);
    if (operands.empty()) return options;
    if (std::ranges::any_of(m_operands, isOption))
        return options + (options.empty() ? "-- " : " -- ") + operands;
    return options.empty() ? operands : operands + " " + options;
}

long Arguments::number(std::string_view option, long fallback, long low, long high) const {
    const std::optional<std::string> text = value(option);
    if (!text) return fallback;
    const std::optional<long> number = wholeNumberIn<long>(*text);
    if (!number || *number < low || *number > high)
        refuse(refusedValue(OptionSpec{option, {}, {}}.text(), *text, wholeNumberProblem(low, high)));
    return *number;
}

std::vector<std::string> shellWords(std::string_view line) {
    std::vector<std::string> words;
    bool isQuoted = false;
    bool isOpen = false;  // a word has begun
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!isQuoted && line[i] == ' ') {
            isOpen = false;
            continue;
        }
        if (!isOpen) words.emplace_back();
        isOpen = true;
        if (line[i] == '\'')
            isQuoted = !isQuoted;
        else if (line[i] == '\\' && !isQuoted && i + 1 < line.size())
            words.back() += line[++i];
        else
            words.back() += line[i];
    }
    return words;
}

}  // namespace drillwave
