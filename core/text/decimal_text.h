// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal numbers in text, in the C locale: finding them, shifting them by powers of ten without rounding,
// and shortening them for messages.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {

/// Returns the text without blanks and tabs at either end.
std::string_view trimmed(std::string_view text);

/// Returns the text with an ASCII hyphen for the minus sign U+2212, and with blanks for the spaces U+00A0,
/// U+202F and U+2009. Word processors and spreadsheets put these characters into numbers.
std::string withPlainSigns(std::string_view text);
/// Returns whether the text has a byte that is not ASCII, so that withPlainSigns() may change it.
bool hasWideCharacters(std::string_view text);

/// Returns the first 40 bytes of a text or less, for quoting in a message, with "…" if it was cut. Control
/// characters become blanks; other unprintable bytes are escaped, as "\xE9".
std::string shortened(std::string_view text);

/// Returns a message that refuses a value: "beta = -1 (must be above 0)". The value is shortened to about
/// 40 bytes.
inline Message refusedValue(std::string_view name, std::string_view value, Message reason) {
    return {"%1 = %2 (%3)", {std::string(name), shortened(value), std::move(reason)}};
}

/// Returns the length in bytes of the finite decimal number at the beginning of a text, such as "+1.5e3".
/// Returns 0 if there is none, also for "nan" and "inf".
std::size_t numberLength(std::string_view text);

/// Returns the whole number that fills the entire text. Returns nullopt if the text is anything else, or if
/// the number is too large for the type.
template <std::integral Number>
std::optional<Number> wholeNumberIn(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return number;
}

/// Returns the message "must be a whole number from 1 to 9" with these limits, both of which are allowed.
template <std::integral Number>
Message wholeNumberProblem(Number low, Number high) {
    return {translatable("must be a whole number from %1 to %2"),
            {std::to_string(low), std::to_string(high)}};
}

/// Returns number × 10^exponent, rounded only once, so that ("38", −3) gives 0.038. `number` must have the
/// form that numberLength() accepts. Returns nullopt if the result overflows, or underflows to an inexact
/// value.
std::optional<double> scaledNumber(std::string_view number, int exponent);

/// Returns value × 10^exponent as text: the shortest digits of `value` with the decimal point moved, so that
/// nothing is rounded.
std::string shiftedNumber(double value, int exponent);

}  // namespace drillwave
