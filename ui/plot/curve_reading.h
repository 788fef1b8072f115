// SPDX-License-Identifier: GPL-3.0-or-later
// Values, slope, mean and integral of a curve between two cursors.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Values in the units shown; NaN where the curve has no such value.
struct CursorReading {
    double a = 0;   ///< x of cursor A
    double b = 0;   ///< x of cursor B
    double yA = 0;  ///< right of a jump, as everywhere here
    double yB = 0;
    double slope = 0;     ///< of the straight line from A to B, in CurveMeaning's unit
    double mean = 0;      ///< of the curve over the time between A and B
    double integral = 0;  ///< from A to B, negative when B is left of A, in CurveMeaning's unit
};

/// Reads a curve at a and b: exactly where its meaning gives the exact functions, else from its points.
CursorReading readCurve(const QCPGraphDataContainer& points, const CurveMeaning& meaning, double a, double b);

/// Returns the piecewise linear curve through the points at x; at a jump (a key twice) the value after it;
/// NaN outside of the points.
double chordValue(const QCPGraphDataContainer& points, double x);

/// ∫ of the piecewise linear curve through the points from a to b, exact but for rounding; 0 outside of them.
double chordIntegral(const QCPGraphDataContainer& points, double a, double b);

}  // namespace drillwave
