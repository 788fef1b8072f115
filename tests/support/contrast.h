// SPDX-License-Identifier: GPL-3.0-or-later
// Relative luminance and contrast of colours as defined by WCAG 2.1.
#pragma once

#include <QColor>
#include <algorithm>
#include <cmath>

namespace drillwave::test {

/// Smallest contrast ratio that WCAG 2.1 permits for text of normal size.
inline constexpr double leastContrast = 4.5;

inline double luminance(const QColor& colour) {
    const auto linear = [](double channel) {
        return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// Returns the colour that results from painting a translucent colour over another one.
inline QColor over(const QColor& front, const QColor& back) {
    const double a = front.alphaF();
    const auto mix = [a](double f, double b) { return static_cast<float>(a * f + (1 - a) * b); };
    return QColor::fromRgbF(mix(front.redF(), back.redF()), mix(front.greenF(), back.greenF()),
                            mix(front.blueF(), back.blueF()));
}

inline double contrast(const QColor& front, const QColor& back) {
    const double a = luminance(over(front, back)), b = luminance(back);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

}  // namespace drillwave::test
