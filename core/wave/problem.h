// SPDX-License-Identifier: GPL-3.0-or-later
// What is solved: one blow on one rod and one rock, dimensionless.
#pragma once

#include "core/contact/bit_rock_law.h"
#include "core/model/pulse_force.h"

namespace drillwave {

/// One blow as every solver takes it: times in t0, forces in F0, impulses in I0. A solver takes a problem or
/// refuses it with a reason.
struct Problem {
    PulseForce hammer;        ///< Fa(t)/F0 at the rear end of the rod
    double transitTime = 10;  ///< τ = T/t0, one way through the rod; > 0
    BitRockLaw law;           ///< β and γ of bit and rock
    double gap = 0;           ///< δ = d/d0 between bit and rock, d0 = 2 I0/Z; ≥ 0
    bool operator==(const Problem&) const = default;

    /// The gap that has to close before anything happens: the reference case begins in contact.
    double firstGap() const { return hammer.isRigidBody() ? 0 : gap; }
};

/// The blow of a valid scenario. The pulse may hold 100 000 points: to solve many blows of one pulse, change
/// one problem.
Problem problemOf(const Scenario& scenario);

/// The blow of this hammer force on the rod and rock of these groups.
Problem problemOf(PulseForce hammer, const Groups& groups);

}  // namespace drillwave
