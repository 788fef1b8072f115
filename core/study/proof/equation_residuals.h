// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals of the equations for a recorded blow. They are computed independently of the solver: the rock law
// is deliberately written again here, without core/contact.
#pragma once

#include <cstddef>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Largest residuals of the equations of rod and rock at many points of the histories of a solved blow, as
/// forces in units of F0. Each is divided by 1 + β/γ, the steepest slope of the force. Rounding of a time
/// unavoidably causes an error of that size.
struct EquationResiduals {
    double wave = 0;  ///< residual of g(s) = Fa(s) + g(s − 2τ) − F(s − 2τ) [paper (6)]
    /// Residual of F' = a (2g − F) [paper (5)] [paper (8)], with the force F on the rock and the incident
    /// wave g. The factor a is the loading slope β where the penetration is the largest so far, otherwise the
    /// unloading slope β/γ.
    double rate = 0;
    /// Residual of the rock law F = max(0, βUm − (β/γ)(Um − U)). The penetration U follows from U' = 2g − F;
    /// Um is its maximum so far. If the rock law has corners, its loading curve replaces βUm. This equation
    /// covers contact and separation (theory, eq. T5), so no events of the solver are needed.
    double law = 0;
    /// Number of straight lines that form the loading curve of the rock; more than one if the rock law has
    /// corners.
    std::size_t loadingLines = 1;
    /// Smallest force F on the rock, not divided by 1 + β/γ; below 0 only by rounding, because the rock
    /// cannot pull.
    double leastForce = 0;
    long points = 0;  ///< number of points of the histories that were checked
};

/// Returns the residuals of the equations for a solved blow with Detail::histories, in which waves are smooth
/// pieces. If the solver missed an event or added a false one, a residual is as large as its effect.
EquationResiduals equationResiduals(const Impact& impact, const Problem& problem);

}  // namespace drillwave
