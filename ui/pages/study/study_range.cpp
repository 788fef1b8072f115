// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/study_range.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drillwave {
namespace {

std::string valueText(const Parameter& parameter, double si) {
    return formatQuantity(si, parameter.quantity, parameter.displayUnit());
}

// The nearest number with one significant digit, in the unit that the parameter is shown in.
double readable(const Parameter& parameter, double si) {
    const Unit& unit = parameter.displayUnit();
    const double shown = unit.fromSi(si);
    if (!(std::abs(shown) > 0) || !std::isfinite(shown)) return si;
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(shown))));
    const double digit = std::round(shown / std::pow(10, exponent));
    // Through text: 0.3, not 0.30000000000000004.
    return unit.toSi(*parseNumber(formatNumber(digit) + "e" + std::to_string(exponent)));
}

}  // namespace

std::string StudyRange::text() const {
    return std::string(parameter->key) + "=" + valueText(*parameter, start) + ":" +
           valueText(*parameter, stop);
}

StudyRange rangeAround(const Parameter& parameter, const Scenario& scenario) {
    const Range& hard = parameter.hard;
    const Range& usual = parameter.plausible;
    const double value = parameter.value(scenario).value_or(0);
    const bool logarithmic = parameter.slider == SliderScale::logarithmic;
    StudyRange range{&parameter, usual.low, usual.high, logarithmic};
    if (value > 0) {
        range.start = logarithmic ? value / 10 : std::min(usual.low, value);
        range.stop = logarithmic ? value * 10 : value * 2;
    }
    range.start = readable(parameter, range.start);
    range.stop = readable(parameter, range.stop);
    if (!hard.contains(range.stop)) range.stop = hard.contains(hard.high) ? hard.high : usual.high;
    if (!hard.contains(range.start)) range.start = hard.contains(hard.low) ? hard.low : usual.low;
    return range;
}

std::string StudyFamily::text() const {
    if (!parameter) return {};
    std::string text(parameter->key);
    char separator = '=';
    for (const double si : values) {
        text.push_back(std::exchange(separator, ','));
        text.append(valueText(*parameter, si));
    }
    return text;
}

}  // namespace drillwave
