// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of the model with a measured force.
#pragma once

#include <functional>
#include <optional>

#include "core/blow/blow.h"
#include "core/signal/alignment.h"

namespace drillwave {

struct BlowCurves;

/// Computed force [N] as a function of time [s] from 0 to `end` [s].
struct ComputedForce {
    std::function<double(double time)> at;
    double end;
};

/// Returns the position x/L for a distance x [m] from the struck end; both are negative in the hammer.
/// Positions beyond hammer or bit are limited to their ends.
double shareAt(const Scenario& scenario, double x);

/// Returns the computed force to compare with a signal: N at the place of the signal, or the impact force. It
/// covers the time span of `curves`. Requires a blow with time histories and physical units; the blow is
/// copied.
ComputedForce computedForce(const Blow& blow, const MeasuredSignal& signal, const BlowCurves& curves);

/// Returns the deviation of a signal from the computed force; nothing if they have no time in common.
std::optional<Misfit> misfitOf(const MeasuredSignal& signal, const ComputedForce& computed);

}  // namespace drillwave
