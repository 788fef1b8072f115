// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal numbers as text: found, shifted by powers of ten without rounding, and cut for messages. C locale.
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

/// The text with the minus sign U+2212 as a hyphen and the no-break and thin spaces U+00A0, U+202F, U+2009 as
/// blanks: the characters that word processors and spreadsheets put into numbers.
std::string withPlainSigns(std::string_view text);
/// Whether withPlainSigns() may change the text: it holds a byte that is not ASCII.
bool hasWideCharacters(std::string_view text);

/// At most about 40 bytes of it, control characters replaced, the rest printable(), for quoting in a message.
std::string shortened(std::string_view text);

/// Why something cannot have a value: "beta = -1 (must be above 0)", the value shortened.
inline Message refusedValue(std::string_view name, std::string_view value, Message reason) {
    return {"%1 = %2 (%3)", {std::string(name), shortened(value), std::move(reason)}};
}

/// Length of the finite decimal number at the beginning ("+1.5e3"), 0 if there is none (also for nan and
/// inf).
std::size_t numberLength(std::string_view text);

/// A whole number and nothing else; nullopt where it is none, or too large for the type.
template <std::integral Number>
std::optional<Number> wholeNumberIn(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return number;
}

/// "must be a whole number from 1 to 9", the reason where it is another.
template <std::integral Number>
Message wholeNumberProblem(Number low, Number high) {
    return {translatable("must be a whole number from %1 to %2"),
            {std::to_string(low), std::to_string(high)}};
}

/// number × 10^exponent rounded once, so that ("38", −3) is 0.038. `number` as numberLength() found it.
/// nullopt where the result would overflow, or underflow to something inexact.
std::optional<double> scaledNumber(std::string_view number, int exponent);

/// value × 10^exponent as the shortest digits of `value` with the point moved: nothing is rounded.
std::string shiftedNumber(double value, int exponent);

}  // namespace drillwave
