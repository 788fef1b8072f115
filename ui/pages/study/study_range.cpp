// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/study_range.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/blow/feed_estimate.h"
#include "core/model/scales.h"
#include "core/model/validation.h"
#include "core/study/rows/sweep_axis.h"
#include "core/text/handy_text.h"

namespace drillwave {
namespace {

std::string valueText(const Parameter& parameter, double si) {
    return formatQuantity(si, parameter.quantity, parameter.displayUnit());
}

bool isValidAt(const Parameter& parameter, Scenario scenario, double si) {
    if (!rangeProblem(parameter, si).isEmpty()) return false;
    parameter.assign(scenario, si);
    return validate(scenario).empty();
}

/// Half as much to half as much again, nearer where the section has no such values, as of a diameter that the
/// bore does not leave room for; what there is usually none of goes up to a tenth of what is plausible.
StudyRange rangeAroundSection(const Parameter& parameter, const Scenario& scenario) {
    const double value = parameter.value(scenario).value_or(0);
    if (!(value > 0)) return {parameter, 0, parameter.plausible.high / 10, false};
    const auto end = [&](double sign) {
        for (const double share : {0.5, 0.4, 0.3, 0.2, 0.1}) {
            const double si = readableNear(parameter, value * (1 + sign * share));
            if (si * sign > value * sign && isValidAt(parameter, scenario, si)) return si;
        }
        return value * (1 + sign / 100);
    };
    return {parameter, end(-1), end(1), false};
}

}  // namespace

double readable(double shown) {
    return QString::number(shown, 'g', 4).toDouble();  // C locale, whatever the user's
}

double readableNear(const Parameter& parameter, double si) {
    const Unit& unit = parameter.displayUnit();
    const double shown = unit.fromSi(si);
    if (!(std::abs(shown) > 0) || !std::isfinite(shown)) return si;
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(shown))));
    const double digit = std::round(shown / std::pow(10, exponent));
    // Through text: 0.3, not 0.30000000000000004.
    return unit.toSi(*parseNumber(formatNumber(digit) + "e" + std::to_string(exponent)));
}

std::string StudyRange::text() const {
    return std::string(parameter->key) + "=" + valueText(*parameter, start) + ":" +
           valueText(*parameter, stop);
}

StudyRange rangeAround(const Parameter& parameter, const Scenario& scenario) {
    if (parameter.address) return rangeAroundSection(parameter, scenario);
    const Range& hard = parameter.hard;
    const Range& usual = parameter.plausible;
    const double value = parameter.value(scenario).value_or(0);
    const bool logarithmic = parameter.slider == SliderScale::logarithmic;
    StudyRange range{parameter, usual.low, usual.high, logarithmic};
    if (value > 0) {
        range.start = logarithmic ? value / 10 : std::min(usual.low, value);
        range.stop = logarithmic ? value * 10 : value * 2;
    }
    range.start = readableNear(parameter, range.start);
    range.stop = readableNear(parameter, range.stop);
    if (!hard.contains(range.stop)) range.stop = hard.contains(hard.high) ? hard.high : usual.high;
    if (!hard.contains(range.start)) range.start = hard.contains(hard.low) ? hard.low : usual.low;
    return range;
}

StudyRange rangeOfManyBlows(const Parameter& parameter, const Scenario& scenario) {
    constexpr int readableDigits = 2;
    constexpr double leastRatio = 2;  // of its ends
    StudyRange range = rangeAround(parameter, scenario);
    if (parameter.key != "drill.thrust" || !scenario.drill.blowFrequency) return range;
    const double reaction = *scenario.drill.blowFrequency * pulseImpulse(scenario);
    const double least = reaction - weightAlongHole(scenario).value_or(0);
    if (!(least > range.start)) return range;
    const Unit& unit = parameter.displayUnit();
    const auto readable = [&](double si) {
        return unit.toSi(
            *parseNumber(rounded(roundedTo(unit.fromSi(si), readableDigits, Rounding::up), readableDigits)));
    };
    range.start = readable(least);
    range.stop = std::max(range.stop, readable(leastRatio * least));
    return range;
}

std::uint64_t StudyRange::pointsWithin(std::uint64_t most) const {
    return parameter ? countWithin(*parameter, start, stop, most) : most;
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
