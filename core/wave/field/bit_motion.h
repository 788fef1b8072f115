// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bit is: how deep in the rock, or how far from it.
#pragma once

#include <functional>
#include <span>

#include "core/wave/field/wave_fronts.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Displacement of the front end towards the rock since the beginning of the blow (since first contact in the
/// reference case, negative before it), u = ∫(2g − F) ds / 2 [d0], at the global time t/t0.
double bitDisplacement(const Impact& impact, double t);

struct BitState {
    bool touching = false;
    double penetration = 0;  ///< U [d0] below the first surface of the rock; meaningful while touching
    double gap = 0;          ///< to the bottom of the crater [d0], while apart
};

/// At the global time t/t0; `contacts` are contactIntervals() of the impact, `delta` the first gap δ [d0].
/// Accurate to some 1e-15 of the displacement so far. Needs an impact solved with Detail::histories.
BitState bitState(const Impact& impact, std::span<const ContactInterval> contacts, double delta, double t);

/// The same of a bit that has come so far towards the rock at each time.
BitState bitState(const std::function<double(double)>& displacementAt,
                  std::span<const ContactInterval> contacts, double delta, double t);

}  // namespace drillwave
