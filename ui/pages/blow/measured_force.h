// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of the model with a measured force.
#pragma once

#include <functional>
#include <optional>

#include "core/blow/blow.h"
#include "core/signal/alignment.h"

namespace drillwave {

struct BlowCurves;

/// Force [N] over time [s] from 0 to `end`.
struct ComputedForce {
    std::function<double(double time)> at;
    double end;
};

/// x/L of a place that is x [m] from the struck end, in the rod or string, or in its hammer.
double shareAt(const Scenario& scenario, double x);

/// N in the section of the signal, or the impact force, over the time that curves of the blow show. The blow
/// has its histories, and its scenario units; it is copied.
ComputedForce computedForce(const Blow& blow, const MeasuredSignal& signal, const BlowCurves& curves);

/// Returns nothing if they have no time in common.
std::optional<Misfit> misfitOf(const MeasuredSignal& signal, const ComputedForce& computed);

}  // namespace drillwave
