// SPDX-License-Identifier: GPL-3.0-or-later
// Meaning of a curve of a plot: its names and units, and the exact function that its points sample.
#pragma once

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <functional>

namespace drillwave {

/// Units, names and exact functions of a curve, for readings and copied data. All values are in the units of
/// the axes.
struct CurveMeaning {
    QString xName = {};  ///< name of x, such as "t"; if empty, the label of the axis is used
    QString yName = {};  ///< name of y, such as "F"; if empty, the label of the axis is used
    QString xUnit = {};  ///< unit of x, such as "ms"; empty for a dimensionless number
    QString yUnit = {};  ///< unit of y, such as "kN"; empty for a dimensionless number
    /// Words shown at x = 0, 1, … instead of numbers. Between them the curve has no values and no slope.
    /// Empty for an axis of numbers.
    QStringList xWords = {};
    /// Unit of the slope as shown to the user. If empty, it is made from the units of y and x, such as
    /// "kN/ms".
    QString slopeUnit = {};
    /// Factor for the slope shown to the user: shown slope = slopeFactor · dy/dx.
    double slopeFactor = 1;
    /// Unit of the integral shown to the user, such as "N s". If empty, it is made from the units of y and x,
    /// such as "kN·ms".
    QString integralUnit = {};
    /// Factor for the integral shown to the user: shown integral = integralFactor · ∫ y dx. The value 0 hides
    /// integral and mean, which have no meaning if x is a parameter or a frequency.
    double integralFactor = 1;
    /// Exact function y(x) of which the drawn points are samples. If empty, y is interpolated linearly
    /// between the points.
    std::function<double(double x)> value = {};
    /// Exact ∫ y dx from a to b, which changes sign if a and b are swapped. If empty, the line through the
    /// drawn points is integrated.
    std::function<double(double a, double b)> integral = {};

    /// Returns the word shown on the axis nearest to x. Empty if the axis shows numbers instead of words, or
    /// x is NaN.
    QString wordAt(double x) const {
        if (xWords.isEmpty() || std::isnan(x)) return {};
        return xWords[std::clamp<qsizetype>(std::lround(x), 0, xWords.size() - 1)];
    }

    /// Returns the meaning of a curve that shows a result over a parameter. Integral and mean of such a curve
    /// are not shown.
    static CurveMeaning overParameter(const QString& xUnit, const QString& yUnit) {
        return {.xUnit = xUnit, .yUnit = yUnit, .integralFactor = 0};
    }
};

}  // namespace drillwave
