// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the force between bit and rock, in dimensionless form.
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

/// Corner of the loading curve of the bit–rock law: above this force the curve has another slope.
struct LawCorner {
    /// Force F_j at the corner, in units of F0; > 0, and not less than that of the previous corner.
    double force = 0;
    double slope = 1;  ///< slope above the corner as a multiple s_j of β; 0 < s_j ≤ 1/γ
    bool operator==(const LawCorner&) const = default;
};

/// Bit–rock law F(U). The loading curve starts at zero with the slope s_0 β; above corner j its slope is
/// s_j β. Below the largest force so far the force falls and rises with the slope β/γ. Without corners the
/// law is bilinear.
struct BitRockLaw {
    double beta = 0.5;  ///< stiffness of loading β = k t0/Z > 0, in units of k0 = Z/t0
    /// Elasticity γ = loading/unloading stiffness, 0 < γ ≤ 1; a rock with 1 is elastic.
    double gamma = 1;
    double firstSlope = 1;  ///< slope s_0 of the first line as a multiple of β; 0 < s_0 ≤ 1/γ
    std::vector<LawCorner> corners = {};  ///< corners with increasing forces, at most mostLawCorners
    bool operator==(const BitRockLaw&) const = default;

    /// Returns whether unloading follows the loading curve, so that the rock absorbs no energy.
    bool isElastic() const { return gamma == 1 && isBilinear(); }
    bool isBilinear() const { return corners.empty() && firstSlope == 1; }
};

inline constexpr std::size_t mostLawCorners = 64;

// Slopes of the loading line and the unloading line, which are the rates at which the contact force changes.

/// Slopes a of F = aU + const. on the two lines of the bit–rock law: β in primary loading, β/γ on the elastic
/// line. In contact they are also the rates of the force [1/t0]: F' = a(2g − F), where g is the incident wave
/// (T16).
template <class Real>
struct ContactRates {
    Real primary = 0;
    Real elastic = 0;
};

// Loading curve that a scenario defines for the bit–rock law (files §1.4).

/// Sets the first slope and the corners of a bit–rock law to those of the scenario; β and γ of the law must
/// already be set. Requires a valid scenario.
void setLines(BitRockLaw& law, const Scenario& scenario);

/// Sets the loading curve to a power law of exponent p = `exponent`, F = βU (U/U1)^(p − 1), approximated by
/// straight lines (theory §1.1). U1 = `reference` > 0 is in I0/Z; 0.3 ≤ p ≤ 3. Nodes are at U1 2^(i/4), i =
/// −32 … 31; the first line begins at zero, the last one has no end. No line is steeper than β/γ. The
/// relative error of the force is at most 0.0038 |p (p − 1)|, and zero at U1. For p = 1 the law is bilinear.
void setPowerLines(BitRockLaw& law, double exponent, double reference);

}  // namespace drillwave
