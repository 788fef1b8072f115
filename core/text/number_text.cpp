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
    // The largest double has 309 digits before its point.
    char text[400];
    const auto end = std::to_chars(text, text + sizeof text, value, format, digits);
    return {text, end.ptr};
}

std::string rounded(double value, int digits) {
    return numberText(value, std::chars_format::general, digits);
}

std::string boundText(double bound) {
    // 5 % more: half of the last digit at most is rounded away
    constexpr double margin = 1.05;
    return rounded(margin * bound, 2);
}

}  // namespace drillwave
