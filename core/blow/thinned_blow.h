// SPDX-License-Identifier: GPL-3.0-or-later
// Measured hammer force reduced to as few points as a stated error allows; computing time grows with the
// number of points.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/signal/samples.h"
#include "core/signal/signal_recipe.h"

namespace drillwave {

// Change of the coefficient of restitution of a measured blow if only some of its samples are used

/// Maximum number of samples of a measured blow from which the hammer force is made. It is also the largest
/// number of points of a force table in a scenario.
inline constexpr std::size_t mostSamplesFollowed = 100'000;

/// Coefficient of restitution of a measured blow if only some of its samples are used, and its error.
struct ThinningEffect {
    /// Coefficient of restitution e if only the selected samples are used.
    double cor = 0;
    /// Change of the coefficient of restitution: `cor` minus its value with all samples. If there are more
    /// than mostSamplesFollowed samples, that value uses only so many of them.
    double change = 0;
    /// Upper bound of the absolute numerical error of the difference `change`.
    double error = 0;
};

/// Returns how the coefficient of restitution of a measured blow changes if samples are left out. Rod and
/// rock are those of the scenario. `recipe` describes how the hammer force is made from the samples; `kept`
/// is the force with fewer points. Returns nullopt for a drill string, if no sample was left out, or after a
/// stop request. Also returns nullopt if one of the two blows is invalid or cannot be solved.
std::optional<ThinningEffect> thinningEffect(const Scenario& scenario, const Samples& samples,
                                             const SignalRecipe& recipe, const ShapedSignal& kept,
                                             const std::stop_token& stop = {});

/// Limit of the errors that thinnedBlow() may cause by leaving out samples: change of the coefficient of
/// restitution, and relative change of the impulse.
inline constexpr double thinningError = 1e-4;

/// Measured hammer force with reduced points, and the effect of the reduction.
struct ThinnedBlow {
    /// Hammer force made from the samples that were kept.
    ShapedSignal signal;
    /// Magnitude of the relative change of the impulse, compared with all samples.
    double impulseChange = 0;
    /// Change of the coefficient of restitution compared with all samples; nullopt if it could not be
    /// computed. For a drill string, it is the change for a similar uniform rod, see uniformRodOf().
    std::optional<double> corChange = {};
    /// Whether samples of the measured force were left out.
    bool isThinned = false;
};

/// Returns the hammer force made from as few samples as possible, at most recipe.points. Coefficient of
/// restitution and impulse change by at most `thinningError`, if recipe.points are enough for this. Otherwise
/// it has recipe.points, or all samples if these are fewer. For a drill string, the coefficient is that of a
/// similar uniform rod, see uniformRodOf(). The search solves many blows, which takes time. Requires samples
/// without a problem.
ThinnedBlow thinnedBlow(const Scenario& scenario, const Samples& samples, const SignalRecipe& recipe,
                        const std::stop_token& stop = {});

}  // namespace drillwave
