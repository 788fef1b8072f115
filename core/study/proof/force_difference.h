// SPDX-License-Identifier: GPL-3.0-or-later
// How far two solutions of the same blow differ in their force histories.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Largest |F − F| over times, F0.
struct ForceDifference {
    /// Over the ends and middles of all pieces of both histories, as a plot of them would show. A history
    /// that is constant in each step differs by at least the change of the force in half a step.
    double largest = 0;
    /// Over the middles of the pieces of the first history, where a mean over a step is closest.
    double inMiddles = 0;
};

/// Requires impacts solved with Detail::histories; `reference` must be continuous, as the exact force is.
ForceDifference forceDifference(const Impact& impact, const Impact& reference);

}  // namespace drillwave
