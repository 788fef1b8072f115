// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes, mean and integral of the part of a curve that is in view.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Values in the units shown; NaN if no part of the curve is in view.
struct ViewStatistics {
    double begin = 0;  ///< x where the part in view begins
    double end = 0;
    double least = 0;    ///< smallest y
    double leastAt = 0;  ///< x where it is first
    double largest = 0;
    double largestAt = 0;
    double mean = 0;
    double integral = 0;  ///< in CurveMeaning's unit
};

/// Extremes are those of the drawn points and of the ends of the view, mean and integral as readCurve() has
/// them.
ViewStatistics viewStatistics(const QCPGraphDataContainer& points, const CurveMeaning& meaning,
                              QCPRange view);

}  // namespace drillwave
