// SPDX-License-Identifier: GPL-3.0-or-later
// The needs of the thrust along a parameter as CSV.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep_axis.h"
#include "core/study/thrust/thrust_curve.h"

namespace drillwave {

/// A parameter, its values, and the needs at each.
struct ThrustAlong {
    SweepAxis axis;
    ThrustCurve curve;
};

/// Points of a range for which no number was given.
inline constexpr std::uint64_t customaryThrustPoints = 101;
/// Points that may be asked for.
inline constexpr std::uint64_t mostThrustPoints = 10'000;

/// All values of the axis, SI.
std::vector<double> valuesOf(const SweepAxis& axis);

/// One row for each point: the parameter in the unit of its axis; of each case f I0 (1+e) and, `_undamped`,
/// f I0 (1+2e) [N]; then the effective force, the margin over the largest need, the gap at the blow by the e
/// of the blow [m], n_b and the verdict. Where something is not known, its cell is empty.
std::string thrustCsv(const ThrustAlong& along);

}  // namespace drillwave
