// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/handy_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace drillwave {

namespace {

/// 350 of two digits is "350", not "3.5e+02".
std::string withoutPower(const ReadingStyle& style, double value, int digits) {
    constexpr int mostBeforePoint = 6;
    const double told = parseNumber(rounded(value, digits)).value_or(value);
    if (!(std::abs(told) >= 1) || !std::isfinite(told)) return style.number(value, digits);
    const int beforePoint = static_cast<int>(std::floor(std::log10(std::abs(told)))) + 1;
    if (beforePoint <= digits || beforePoint > mostBeforePoint) return style.number(value, digits);
    return style.number(told, beforePoint);
}

}  // namespace

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

std::string ReadingStyle::magnitude(double value) const {
    return withDecimalSign(numberText(value, std::chars_format::scientific, 1));
}

std::string ReadingStyle::said(const Message& message) const {
    return message.said([this](const std::string& english) { return patternFor(english); });
}

ReadUnit ReadingStyle::unitFor(double si, Quantity quantity) const {
    // Units of all quantities, for each from the smallest on.
    constexpr std::array<std::string_view, 21> handy{"us",  "ms",  "s",   "um",  "mm",   "m",    "mm^2",
                                                     "N s", "N",   "kN",  "J",   "kJ",   "W",    "kW",
                                                     "kg",  "MPa", "GPa", "N/m", "kN/m", "MN/m", "GN/m"};
    const Unit* chosen = nullptr;
    for (const std::string_view name : handy) {
        const Unit* unit = findUnit(quantity, name);
        if (!unit) continue;
        const bool fits =
            si == 0 ? unit->fromSi(1) == 1 : std::abs(unit->fromSi(si)) >= 1;  // zero has no prefix
        if (!chosen || fits) chosen = unit;
    }
    if (!chosen) chosen = &unitsOf(quantity).front();
    return {chosen, std::string(chosen->name)};
}

ReadUnit ReadingStyle::rateUnit(double /*si*/) const {
    constexpr std::string_view name = "m/min";
    return {findUnit(Quantity::velocity, name), std::string(name)};
}

std::string ReadingStyle::quantity(double si, Quantity quantity, int digits, Rounding rounding) const {
    return inUnit(si, unitFor(si, quantity), digits, rounding);
}

std::string ReadingStyle::rate(double si, int digits) const {
    return inUnit(si, rateUnit(si), digits, Rounding::nearest);
}

std::string ReadingStyle::inUnit(double si, const ReadUnit& read, int digits, Rounding rounding) const {
    const std::string text = withoutPower(*this, roundedTo(read.unit->fromSi(si), digits, rounding), digits);
    return read.name.empty() ? text : text + " " + read.name;
}

std::string ReadingStyle::bound(double bound) const {
    // 5 % more: half of the last digit at most is rounded away
    constexpr double margin = 1.05;
    return number(margin * bound, 2);
}

std::string ReadingStyle::withDecimalSign(std::string cText) const {
    const std::string half = number(0.5, 1);  // "0.5", "0,5"
    const std::string sign = half.substr(1, half.size() - 2);
    for (std::size_t at = cText.find('.'); at != std::string::npos; at = cText.find('.', at + sign.size()))
        cText.replace(at, 1, sign);
    return cText;
}

std::string ReadingStyle::signedPercent(double share) const {
    return (share < 0 ? "" : "+") + number(share * 100, 3) + " %";
}

std::string ReadingStyle::name(std::string_view name) const {
    std::string words(name);
    std::ranges::replace(words, '_', ' ');
    std::string here = said(Message::ofTable(words));
    // A name without a translation stays as in files, except on printed pages.
    return here == words && !isPrinted() ? std::string(name) : here;
}

const ReadingStyle& plainStyle() {
    static const ReadingStyle style;
    return style;
}

std::string inHandyUnit(double si, Quantity quantity, int digits) {
    return plainStyle().quantity(si, quantity, digits);
}

}  // namespace drillwave
