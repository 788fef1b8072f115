// SPDX-License-Identifier: GPL-3.0-or-later
// Meaning of a curve of a plot: its units, and the exact function behind its drawn points.
#pragma once

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <functional>

namespace drillwave {

/// All values are in the units of the axes: x as on the horizontal one, y as on the vertical one.
struct CurveMeaning {
    QString xName = {};  ///< "t"; empty for the label of the axis
    QString yName = {};  ///< "F"; empty for the label of the axis
    QString xUnit = {};  ///< "ms"; empty for a mere number
    QString yUnit = {};  ///< "kN"
    /// The words at x = 0, 1, … of an axis of words; between them there is nothing, and no slope.
    QStringList xWords = {};
    /// Shown slope = slopeFactor · dy/dx, followed by slopeUnit; without a unit "kN/ms".
    QString slopeUnit = {};
    double slopeFactor = 1;
    /// Shown integral = integralFactor · ∫y dx, followed by integralUnit ("N s"); without a unit "kN·ms".
    /// Factor 0: over an axis like a parameter or a frequency, integral and mean have no meaning.
    QString integralUnit = {};
    double integralFactor = 1;
    /// Exact y(x); without it values are read from the drawn chords.
    std::function<double(double x)> value = {};
    /// Exact ∫ y dx from a to b, negative of that from b to a; without it the drawn chords are integrated.
    std::function<double(double a, double b)> integral = {};

    /// The word nearest to x; empty where x is a number, or NaN.
    QString wordAt(double x) const {
        if (xWords.isEmpty() || std::isnan(x)) return {};
        return xWords[std::clamp<qsizetype>(std::lround(x), 0, xWords.size() - 1)];
    }

    /// A result over a parameter.
    static CurveMeaning overParameter(const QString& xUnit, const QString& yUnit) {
        return {.xUnit = xUnit, .yUnit = yUnit, .integralFactor = 0};
    }
};

}  // namespace drillwave
