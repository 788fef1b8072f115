// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/name_text.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/text/text_input.h"

namespace drillwave {

namespace {

/// Code points from `first` to `last`.
struct CodeRange {
    char32_t first, last;
    bool contains(char32_t code) const { return code >= first && code <= last; }
};

constexpr CodeRange turning[]{{0x061C, 0x061C}, {0x200E, 0x200F}, {0x202A, 0x202E}, {0x2066, 0x2069}};
constexpr CodeRange controls[]{{0x00, 0x1F}, {0x7F, 0x9F}, {0x2028, 0x2029}, {0xFEFF, 0xFEFF}};
/// Code points beyond ASCII that are no letters: signs, punctuation, symbols and pictures.
constexpr CodeRange signs[]{{0x80, 0xA9},       {0xAB, 0xB4},       {0xB6, 0xB9},     {0xBB, 0xBF},
                            {0xD7, 0xD7},       {0xF7, 0xF7},       {0x0300, 0x036F}, {0x2000, 0x20FF},
                            {0x2190, 0x2BFF},   {0x2E00, 0x2E7F},   {0x3000, 0x3004}, {0x3007, 0x3030},
                            {0xD800, 0xF8FF},   {0xFE00, 0xFE6F},   {0xFEFF, 0xFF20}, {0xFFF0, 0xFFFF},
                            {0x1F000, 0x1FAFF}, {0xE0000, 0x10FFFF}};

template <std::size_t count>
bool isOf(const CodeRange (&ranges)[count], char32_t code) {
    return std::ranges::any_of(ranges, [code](const CodeRange& range) { return range.contains(code); });
}

bool isLetter(char32_t code) {
    if (code < 0x80) return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z');
    return !isOf(signs, code);
}

/// A character of a text that is UTF-8, and its bytes.
struct Character {
    char32_t code = 0;
    std::size_t length = 1;
};

Character characterAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    if (byte(0) < 0x80) return {byte(0), 1};
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    char32_t code = byte(0) & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3FU);
    return {code, length};
}

std::string hexadecimal(char32_t number, int digits) {
    std::string text;
    for (int digit = digits; digit-- > 0;) text += "0123456789ABCDEF"[number >> (4 * digit) & 0xF];
    return text;
}

void appendPrintable(std::string& printed, std::string_view utf8, std::string_view kept) {
    for (std::size_t at = 0; at < utf8.size();) {
        const auto [code, length] = characterAt(utf8, at);
        const bool isKept = code < 0x80 && kept.find(static_cast<char>(code)) != std::string_view::npos;
        if (!isKept && (isOf(turning, code) || isOf(controls, code)))
            printed += code < 0x80 ? "\\x" + hexadecimal(code, 2) : "\\u" + hexadecimal(code, 4);
        else
            printed += utf8.substr(at, length);
        at += length;
    }
}

constexpr std::size_t maximumLength = 40;

/// Number of typing errors between two names (optimal string alignment), upper and lower case being alike.
std::size_t typingErrors(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    std::array<std::array<std::size_t, maximumLength + 1>, maximumLength + 1> errors{};
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                errors[i][j] = i + j;
                continue;
            }
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            errors[i][j] =
                std::min({errors[i - 1][j] + 1, errors[i][j - 1] + 1, errors[i - 1][j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) errors[i][j] = std::min(errors[i][j], errors[i - 2][j - 2] + 1);
        }
    }
    return errors[a.size()][b.size()];
}

}  // namespace

Message lineProblem(std::string_view text) {
    if (!isUtf8(text)) return translatable("must be UTF-8");
    for (std::size_t at = 0; at < text.size();) {
        const auto [code, length] = characterAt(text, at);
        if (code == '\n' || code == '\r') return translatable("must be one line");
        if (isOf(controls, code)) return translatable("must have no control characters");
        if (isOf(turning, code))
            return translatable("must have no characters that change the reading direction");
        at += length;
    }
    return {};
}

Message nameProblem(std::string_view text) {
    if (Message problem = lineProblem(text); !problem.isEmpty()) return problem;
    for (std::size_t at = 0; at < text.size();) {
        const auto [code, length] = characterAt(text, at);
        if (isLetter(code)) return {};
        at += length;
    }
    return translatable("must have a letter");
}

namespace {

std::string printableBut(std::string_view kept, std::string_view text) {
    std::string printed;
    while (!text.empty()) {
        const std::size_t good = utf8Length(text);
        appendPrintable(printed, text.substr(0, good), kept);
        text.remove_prefix(good);
        if (text.empty()) break;
        printed += "\\x" + hexadecimal(static_cast<unsigned char>(text.front()), 2);
        text.remove_prefix(1);
    }
    return printed;
}

}  // namespace

std::string printable(std::string_view text) {
    return printableBut({}, text);
}

std::string printableLines(std::string_view text) {
    return printableBut("\n\t", text);
}

std::string printableLine(std::string_view text) {
    std::string line(text);
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return printable(line);
}

std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates) {
    if (name.empty() || name.size() > maximumLength) return {};
    std::string_view nearest;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > maximumLength) continue;
        const std::size_t dot = candidate.find('.');
        const bool bare = dot != std::string_view::npos && name == candidate.substr(dot + 1);
        const std::size_t errors = bare ? 1 : typingErrors(name, candidate);
        if (errors < fewest && 3 * errors <= std::max(name.size(), std::size_t{3})) {
            fewest = errors;
            nearest = candidate;
        }
    }
    return nearest;
}

namespace {

std::vector<std::string_view> wordsOf(std::string_view name) {
    std::vector<std::string_view> words;
    while (!name.empty()) {
        const std::size_t end = std::min(name.find('_'), name.size());
        if (end > 0) words.push_back(name.substr(0, end));
        name.remove_prefix(std::min(end + 1, name.size()));
    }
    return words;
}

}  // namespace

std::string_view nameWithWords(std::string_view name, std::span<const std::string_view> candidates) {
    constexpr std::size_t leastLetters = 4;
    const std::vector<std::string_view> wanted = wordsOf(name);
    std::string_view shortest;
    for (const std::string_view candidate : candidates) {
        const std::vector<std::string_view> words = wordsOf(candidate);
        const auto isThere = [&](std::string_view word) {
            return word.size() >= leastLetters && std::ranges::any_of(words, [&](std::string_view each) {
                       return each.size() >= leastLetters &&
                              (each.starts_with(word) || word.starts_with(each));
                   });
        };
        if (!wanted.empty() && std::ranges::all_of(wanted, isThere) &&
            (shortest.empty() || candidate.size() < shortest.size()))
            shortest = candidate;
    }
    return shortest;
}

}  // namespace drillwave
