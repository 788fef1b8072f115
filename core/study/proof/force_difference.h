// SPDX-License-Identifier: GPL-3.0-or-later
// Difference between the force histories of two solutions of the same blow.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Largest absolute difference between two force histories, in units of F0.
struct ForceDifference {
    /// Largest difference at the ends and middles of the pieces of both histories, as visible in a plot. A
    /// history that is constant in each step differs by at least the change of the force in half a step.
    double largest = 0;
    /// Largest difference at the middles of the pieces of the first history, where a mean over a step is most
    /// accurate.
    double inMiddles = 0;
};

/// Returns the difference of two force histories. Requires impacts solved with Detail::histories; `reference`
/// must be continuous, as the exact force is.
ForceDifference forceDifference(const Impact& impact, const Impact& reference);

}  // namespace drillwave
