// SPDX-License-Identifier: GPL-3.0-or-later
// Values, slope, mean and integral of a curve between two cursors.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Readings of a curve at the cursors A and B, in the units shown. A reading is NaN if the curve is not
/// defined there.
struct CursorReading {
    double a = 0;      ///< x of cursor A, in the unit of the axis
    double b = 0;      ///< x of cursor B, in the unit of the axis
    double yA = 0;     ///< y at a in the unit of the axis; at a jump, the value right of it
    double yB = 0;     ///< y at b in the unit of the axis; at a jump, the value right of it
    double slope = 0;  ///< slope of the straight line from A to B, in CurveMeaning::slopeUnit
    double mean = 0;   ///< mean of the curve between A and B, in the unit of the y axis
    /// Integral from A to B in CurveMeaning::integralUnit; its sign changes if B is left of A.
    double integral = 0;
};

/// Returns the readings of a curve at the cursors x = a and x = b. Uses the exact functions of `meaning` if
/// it has them, else the line through the points.
CursorReading readCurve(const QCPGraphDataContainer& points, const CurveMeaning& meaning, double a, double b);

/// Returns y at x on the straight lines that join the points. At a jump (two points with equal x) it is the
/// value after the jump; outside the range of the points it is NaN.
double chordValue(const QCPGraphDataContainer& points, double x);

/// Returns the integral over x from a to b of the straight lines that join the points, exact except for
/// rounding. The curve counts as zero outside the range of the points.
double chordIntegral(const QCPGraphDataContainer& points, double a, double b);

}  // namespace drillwave
