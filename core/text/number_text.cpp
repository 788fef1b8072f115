// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include <cmath>

namespace drillwave {

void appendNumber(std::string& row, double value) {
    if (!std::isfinite(value)) return;
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    row.append(text, end.ptr);
}

std::string numberText(double value, std::chars_format format, int digits) {
    if (!std::isfinite(value)) return "–";
    // The largest double has 309 digits before its point.
    char text[400];
    const auto end = std::to_chars(text, text + sizeof text, value, format, digits);
    return {text, end.ptr};
}

std::string rounded(double value, int digits) {
    return numberText(value, std::chars_format::general, digits);
}

double roundedTo(double value, int digits, Rounding rounding) {
    if (rounding == Rounding::nearest || value == 0 || !std::isfinite(value)) return value;
    if (value < 0)
        return -roundedTo(-value, digits, rounding == Rounding::up ? Rounding::down : Rounding::up);
    constexpr double noise = 1e-12;
    const int exponent = static_cast<int>(std::floor(std::log10(value))) + 1 - digits;
    constexpr int mostDigits = 300;  // a digit so far off is no digit of a double
    if (std::abs(exponent) > mostDigits) return value;
    const double power = std::pow(10, std::abs(exponent));
    const double steps = exponent < 0 ? value * power : value / power;
    const double whole =
        rounding == Rounding::up ? std::ceil(steps * (1 - noise)) : std::floor(steps * (1 + noise));
    return exponent < 0 ? whole / power : whole * power;
}

}  // namespace drillwave
