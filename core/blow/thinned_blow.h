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

/// Maximum number of samples of a measured blow that are used; also the longest table that a scenario may
/// have.
inline constexpr std::size_t mostSamplesFollowed = 100'000;

/// Effect on the coefficient of restitution of using only some of the samples of a measured blow.
struct ThinningEffect {
    /// Coefficient of restitution e if only the selected samples are used.
    double cor = 0;
    /// Change of the coefficient of restitution: `cor` less the value with all samples, or with
    /// mostSamplesFollowed of them if there are more.
    double change = 0;
    /// Upper bound of the absolute numerical error of the difference `change`.
    double error = 0;
};

/// Returns the effect of leaving out samples of a measured blow on the coefficient of restitution, with the
/// rod and rock of a scenario. `recipe` makes the hammer force from the samples; `kept` has the points that
/// are used. Returns nothing for a drill string, if no sample was left out, or after a stop request. It also
/// returns nothing if the blow with all samples, or with those of `kept`, is invalid or cannot be solved.
std::optional<ThinningEffect> thinningEffect(const Scenario& scenario, const Samples& samples,
                                             const SignalRecipe& recipe, const ShapedSignal& kept,
                                             const std::stop_token& stop = {});

/// Largest change of the coefficient of restitution, and largest relative change of the impulse, that leaving
/// out samples may cause.
inline constexpr double thinningError = 1e-4;

/// Measured hammer force with reduced points, and the effect of the reduction.
struct ThinnedBlow {
    /// Hammer force made from the points that are used.
    ShapedSignal signal;
    /// Magnitude of the relative change of the impulse, compared with all samples.
    double impulseChange = 0;
    /// Change of the coefficient of restitution compared with all samples; nothing if it could not be
    /// computed. For a drill string, it is that of its uniform rod.
    std::optional<double> corChange = {};
    /// Whether samples of the measured force were left out.
    bool isThinned = false;
};

/// Returns the hammer force made from few of the samples, at most recipe.points. It uses the fewest points
/// tried for which coefficient of restitution and impulse change by no more than `thinningError`. If no
/// number of points is sufficient, it uses recipe.points, or all samples if these are fewer. For a drill
/// string, the coefficient is that of its uniformRodOf(). The search takes time, because many blows are
/// solved. Requires samples without a problem.
ThinnedBlow thinnedBlow(const Scenario& scenario, const Samples& samples, const SignalRecipe& recipe,
                        const std::stop_token& stop = {});

}  // namespace drillwave
