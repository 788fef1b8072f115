// SPDX-License-Identifier: GPL-3.0-or-later
// Difference between the force histories of two solutions of the same blow.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Largest absolute difference between two force histories, in units of F0.
struct ForceDifference {
    /// Largest difference of the forces at the ends and middles of the pieces of both histories. If the force
    /// of one history is constant in each step, as for a lattice, the difference is at least its change in
    /// half a step.
    double largest = 0;
    /// Largest difference at the middles of the pieces of the first history. There a lattice, whose force is
    /// a mean over each step, is most accurate.
    double inMiddles = 0;
};

/// Returns the difference of the force histories of two solutions of one blow, both with Detail::histories.
/// The force of `reference` must be continuous, as in the exact solution.
ForceDifference forceDifference(const Impact& impact, const Impact& reference);

}  // namespace drillwave
