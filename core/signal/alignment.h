// SPDX-License-Identifier: GPL-3.0-or-later
// A measured signal put where it fits a computed one: a recorder begins when it likes.
#pragma once

#include <functional>

#include "core/model/table_points.h"

namespace drillwave {

/// What to add to the times of the measured points [s] so that their product with the computed force,
/// integrated over time, is largest. The computed force is a function of time [s], looked at from 0 to `end`
/// > 0; either counts as 0 outside of its own times. To a 2000th of the longer of both, and between by a
/// parabola. 0 where the product never is positive. Requires at least two points of increasing times.
double bestShift(const TablePoints& measured, const std::function<double(double time)>& computed, double end);

}  // namespace drillwave
