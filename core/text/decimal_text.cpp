// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/decimal_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/text/name_text.h"

namespace drillwave {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t digitsAt(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end])) ++end;
    return end - at;
}

/// Length of "e-12" at that place, 0 if it is no exponent.
std::size_t exponentLength(std::string_view text, std::size_t at) {
    if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return 0;
    std::size_t digits = at + 1;
    if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
    const std::size_t count = digitsAt(text, digits);
    return count == 0 ? 0 : digits + count - at;
}

/// Digits without a point and the power of ten of the first one: 0.038 is "38" and −2.
struct Digits {
    bool negative = false;
    std::string digits;
    int exponent = 0;
};

Digits shortestDigits(double value) {
    std::array<char, 40> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific);
    std::string_view text(buffer.data(), end.ptr);
    Digits result;
    result.negative = text.front() == '-';
    if (result.negative) text.remove_prefix(1);
    const std::size_t e = text.find('e');
    for (const char c : text.substr(0, e))
        if (c != '.') result.digits += c;
    const std::string_view exponent = text.substr(e + (text[e + 1] == '+' ? 2 : 1));
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), result.exponent);
    return result;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool hasWideCharacters(std::string_view text) {
    unsigned any = 0;
    for (const char c : text) any |= static_cast<unsigned char>(c);
    return any >= 0x80;
}

std::string withPlainSigns(std::string_view text) {
    constexpr std::pair<std::string_view, char> signs[] = {
        {"\u2212", '-'}, {"\u00a0", ' '}, {"\u202f", ' '}, {"\u2009", ' '}};
    std::string plain;
    plain.reserve(text.size());
    while (!text.empty()) {
        const auto sign = std::ranges::find_if(
            signs, [&](const auto& candidate) { return text.starts_with(candidate.first); });
        plain += sign == std::end(signs) ? text.front() : sign->second;
        text.remove_prefix(sign == std::end(signs) ? 1 : sign->first.size());
    }
    return plain;
}

std::string shortened(std::string_view text) {
    constexpr std::size_t limit = 40;
    std::size_t length = std::min(text.size(), limit);
    // Never cut inside a UTF-8 sequence.
    while (length < text.size() && length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
        --length;
    std::string result(text.substr(0, length));
    for (char& c : result)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    result = printable(result);
    return length < text.size() ? result + "…" : result;
}

std::size_t numberLength(std::string_view text) {
    std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t whole = digitsAt(text, at);
    at += whole;
    std::size_t decimals = 0;
    if (at < text.size() && text[at] == '.') {
        decimals = digitsAt(text, at + 1);
        if (whole + decimals > 0) at += 1 + decimals;
    }
    if (whole + decimals == 0) return 0;
    return at + exponentLength(text, at);
}

std::optional<double> scaledNumber(std::string_view number, int exponent) {
    if (number.starts_with('+')) number.remove_prefix(1);
    const std::size_t e = number.find_first_of("eE");
    std::string text(number.substr(0, e));
    int given = 0;
    if (e != std::string_view::npos) {
        std::string_view digits = number.substr(e + 1);
        if (digits.starts_with('+')) digits.remove_prefix(1);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), given);
        if (read.ec != std::errc() || std::abs(given) > 1000000) return std::nullopt;
    }
    text += "e" + std::to_string(given + exponent);
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string shiftedNumber(double value, int exponent) {
    if (value == 0 || !std::isfinite(value)) {
        std::array<char, 40> buffer{};
        return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
    }
    const Digits number = shortestDigits(value);
    const int first = number.exponent + exponent;
    const int count = static_cast<int>(number.digits.size());
    std::string text = number.negative ? "-" : "";
    if (first >= 0 && first < 16) {
        if (count <= first + 1)
            return text + number.digits + std::string(static_cast<std::size_t>(first + 1 - count), '0');
        return text + number.digits.substr(0, static_cast<std::size_t>(first + 1)) + "." +
               number.digits.substr(static_cast<std::size_t>(first + 1));
    }
    if (first < 0 && first >= -5)
        return text + "0." + std::string(static_cast<std::size_t>(-first - 1), '0') + number.digits;
    text += number.digits.front();
    if (count > 1) text += "." + number.digits.substr(1);
    return text + "e" + std::to_string(first);
}

}  // namespace drillwave
