// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the force between bit and rock.
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

/// A corner of the loading curve: from this force on it has another slope.
struct LawCorner {
    double force = 0;  ///< F_j [F0]; > 0, and no less than that of the previous corner
    double slope = 1;  ///< s_j, as a multiple of the slope of the first line; 0 < s_j ≤ 1/γ
    bool operator==(const LawCorner&) const = default;
};

/// Numbers of the law: F(U) rises with slope s_0 β from zero, with s_j β from corner j on, and falls and
/// rises again below the largest force so far with slope β/γ, on any line. Without corners the law is
/// bilinear.
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

// The slopes of the two lines of the law, which are the rates of a blow.

/// F = aU + const. along a line, and so F' = a(2g − F), per t0 (T16): a = β in primary loading, β/γ on the
/// elastic line.
template <class Real>
struct ContactRates {
    Real primary = 0;
    Real elastic = 0;
};

// The loading lines that a scenario gives the law of bit and rock (files §1.4).

/// Gives the law the loading lines of the scenario, beside its β and γ. Requires a valid scenario.
void setLines(BitRockLaw& law, const Scenario& scenario);

/// Replaces the loading curve by straight lines near F = βU (U/U1)^(p − 1), with U1 = `reference` > 0 in I0/Z
/// and 0.3 ≤ p ≤ 3 (theory §1.1). Nodes are at U1 2^(i/4), i = −32 … 31; the first line begins at zero, the
/// last one goes on. No line is steeper than β/γ. The force is off by at most 0.38 % of |p (p − 1)|, and
/// exact at U1. For p = 1 the law is bilinear.
void setPowerLines(BitRockLaw& law, double exponent, double reference);

}  // namespace drillwave
