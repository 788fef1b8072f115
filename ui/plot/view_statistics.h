// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes, mean and integral of the part of a curve that is in view.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Statistics of the part of a curve in view, in the units shown. All are NaN if no part of the curve is in
/// view.
struct ViewStatistics {
    double begin = 0;      ///< smallest x of the part in view, in the unit of the axis
    double end = 0;        ///< largest x of the part in view, in the unit of the axis
    double least = 0;      ///< smallest y in view, in the unit of the axis
    double leastAt = 0;    ///< x where the smallest y occurs first
    double largest = 0;    ///< largest y in view, in the unit of the axis
    double largestAt = 0;  ///< x where the largest y occurs first
    double mean = 0;       ///< mean of y over the part in view, in the unit of the axis
    double integral = 0;   ///< integral over the part in view, in CurveMeaning::integralUnit
};

/// Returns the statistics of a curve for x in the range `view`. Values, mean and integral are those of the
/// exact functions of `meaning`, or else of the line through the drawn points. Extremes are searched at the
/// drawn points and at both ends of `view`. With an exact function, they are refined between the neighbouring
/// points.
ViewStatistics viewStatistics(const QCPGraphDataContainer& points, const CurveMeaning& meaning,
                              QCPRange view);

}  // namespace drillwave
