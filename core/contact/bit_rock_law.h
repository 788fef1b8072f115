// SPDX-License-Identifier: GPL-3.0-or-later
// What the force between bit and rock depends on, beside the penetration.
#pragma once

#include <cstddef>
#include <vector>

namespace drillwave {

/// A corner of the loading curve: from this force on it has another slope.
struct LawCorner {
    double force = 0;  ///< F_j [F0]; > 0, and no less than that of the corner before
    double slope = 1;  ///< s_j, as a multiple of the slope of the first line; 0 < s_j ≤ 1/γ
    bool operator==(const LawCorner&) const = default;
};

/// The numbers of the law: F(U) rises with slope s_0 β from zero, with s_j β from corner j on, and goes down
/// and up again below the largest force so far with slope β/γ, whatever line that was on. Without corners the
/// law is bilinear.
struct BitRockLaw {
    double beta = 0.5;                    ///< β = k t0/Z, stiffness of primary loading [Z/t0]; > 0
    double gamma = 1;                     ///< γ, elasticity of the rock, 0 < γ ≤ 1; 1 is elastic
    double firstSlope = 1;                ///< s_0 of the first line; 0 < s_0 ≤ 1/γ
    std::vector<LawCorner> corners = {};  ///< at most mostLawCorners
    bool operator==(const BitRockLaw&) const = default;

    /// Whether the way down is the way up, so that the rock keeps nothing.
    bool isElastic() const { return gamma == 1 && isBilinear(); }
    bool isBilinear() const { return corners.empty() && firstSlope == 1; }
};

inline constexpr std::size_t mostLawCorners = 64;

}  // namespace drillwave
