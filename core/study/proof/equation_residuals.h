// SPDX-License-Identifier: GPL-3.0-or-later
// How well a recorded blow satisfies the equations themselves, found without the code that solved it: the law
// of the rock is written again here, on purpose, and asks nothing of core/contact.
#pragma once

#include <cstddef>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Largest violations over many points of the histories, forces in F0. Each is divided by 1 + β/γ, the
/// steepest slope of a force, because no solver can avoid that times the rounding of a time.
struct EquationResiduals {
    double wave = 0;  ///< of g(s) = Fa(s) + g(s − 2τ) − F(s − 2τ) [paper (6)]
    /// of F' = a (2g − F) [paper (5)] [paper (8)], a = β where the penetration is the largest so far, else
    /// β/γ.
    double rate = 0;
    /// of the law with memory, F = max(0, βUm − (β/γ)(Um − U)), U' = 2g − F, Um = the largest U so far: one
    /// equation for all branches (T5), without events.
    double law = 0;
    std::size_t loadingLines = 1;  ///< of the law: more where it has corners
    double leastForce = 0;         ///< smallest F, not divided: no pull except rounding
    long points = 0;               ///< of the histories looked at
};

/// Returns the residuals of an impact of smooth pieces solved with Detail::histories. An event that was
/// missed or invented shows as a residual of the size of its effect.
EquationResiduals equationResiduals(const Impact& impact, const Problem& problem);

}  // namespace drillwave
