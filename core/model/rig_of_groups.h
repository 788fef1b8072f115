// SPDX-License-Identifier: GPL-3.0-or-later
// From dimensionless groups to a rig with the same groups.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// Rod, force and duration, which the groups leave open.
struct RigChoice {
    Rod rod;                   ///< cross-section, material and strengths; its length follows from τ
    double meanForce = 255e3;  ///< F0 [N]
    double duration = 200e-6;  ///< t0 [s]
};

/// Returns the scenario in physical units with the groups, the shape of the blow and the loading curve of a
/// dimensionless one: L = τ c t0, I0 = F0 t0, k = β Z/t0, d = 2 δ I0/Z. A piston has the material of the rod.
/// The points of a table stand in the scenario itself. Requires a dimensionless scenario and positive values.
Scenario rigOf(const Scenario& groups, const RigChoice& choice);

}  // namespace drillwave
