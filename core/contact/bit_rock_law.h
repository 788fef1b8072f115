// SPDX-License-Identifier: GPL-3.0-or-later
// What the force between bit and rock depends on, beside the penetration.
#pragma once

namespace drillwave {

/// The two numbers of the bilinear law: F(U) rises with slope β, and goes down and up again below the largest
/// force so far with slope β/γ.
struct BitRockLaw {
    double beta = 0.5;  ///< β = k t0/Z, stiffness of primary loading [Z/t0]; > 0
    double gamma = 1;   ///< γ, elasticity of the rock, 0 < γ ≤ 1; 1 is elastic
    bool operator==(const BitRockLaw&) const = default;
};

}  // namespace drillwave
