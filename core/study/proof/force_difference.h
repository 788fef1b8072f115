// SPDX-License-Identifier: GPL-3.0-or-later
// Difference between the force histories of two solutions of the same blow.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Largest absolute difference between two force histories, in units of F0.
struct ForceDifference {
    /// Largest difference of the forces at the ends and middles of the pieces of `impact` and at the middles
    /// of the pieces of `reference`. The force of a lattice is constant in each time step. Its difference is
    /// therefore at least the change of the force within half a step.
    double largest = 0;
    /// Largest difference of the forces at the middles of the pieces of `impact`. A lattice, whose force is a
    /// mean over each time step, is most accurate there.
    double inMiddles = 0;
};

/// Returns the difference between the force histories of two solutions of one blow. Requires that both were
/// solved with Detail::histories, and that the force of `reference` is continuous, as in the exact solution.
ForceDifference forceDifference(const Impact& impact, const Impact& reference);

}  // namespace drillwave
