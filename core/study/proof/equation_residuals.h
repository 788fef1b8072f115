// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals of the equations for a recorded blow. They are computed independently of the solver: the rock law
// is deliberately written again here, without core/contact.
#pragma once

#include <cstddef>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Largest residuals of the equations of rod and rock at many points of the histories, as forces in units of
/// F0. Each is divided by 1 + β/γ, the steepest slope of the force, because rounding of a time causes an
/// unavoidable error of that size.
struct EquationResiduals {
    double wave = 0;  ///< residual of g(s) = Fa(s) + g(s − 2τ) − F(s − 2τ) [paper (6)]
    /// Residual of F' = a (2g − F) [paper (5)] [paper (8)]. The factor a is β where the penetration is the
    /// largest so far, otherwise β/γ.
    double rate = 0;
    /// Residual of the rock law with memory, F = max(0, βUm − (β/γ)(Um − U)) with U' = 2g − F. Um is the
    /// largest U so far. This single equation covers all branches (theory, eq. T5), without use of events.
    double law = 0;
    /// Number of straight lines of the loading curve of the rock; more than one if the rock law has corners.
    std::size_t loadingLines = 1;
    /// Smallest force F on the rock, not divided by 1 + β/γ; below 0 only by rounding, because the rock
    /// cannot pull.
    double leastForce = 0;
    long points = 0;  ///< number of points of the histories that were checked
};

/// Returns the residuals of an impact solved in smooth pieces with Detail::histories. A missed or spurious
/// event shows as a residual of the size of its effect.
EquationResiduals equationResiduals(const Impact& impact, const Problem& problem);

}  // namespace drillwave
