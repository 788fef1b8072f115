// SPDX-License-Identifier: GPL-3.0-or-later
// A measured blow by as few points as a stated error allows: solving takes as long as its points are many.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/signal/samples.h"
#include "core/signal/signal_recipe.h"

namespace drillwave {

// Change of e of a measured blow when only some of its samples are kept.

/// Maximum number of samples followed: that of the longest table of a scenario.
inline constexpr std::size_t mostSamplesFollowed = 100'000;

struct ThinningEffect {
    double cor = 0;     ///< of the kept points
    double change = 0;  ///< `cor` less the e of all samples, or of mostSamplesFollowed of them
    double error = 0;   ///< bound on the numerical error of the change
};

/// Solves the blow that a recipe makes of samples, on the rod and the rock of a scenario, by the points that
/// `kept` has and by all samples. Nothing where no sample was left out, for a drill string, which is not
/// struck by a force, where one of both is no valid blow or is not solved, and on a stop.
std::optional<ThinningEffect> thinningEffect(const Scenario& scenario, const Samples& samples,
                                             const SignalRecipe& recipe, const ShapedSignal& kept,
                                             const std::stop_token& stop = {});

/// Largest change of e and relative change of the impulse that thinning may cause.
inline constexpr double thinningError = 1e-4;

struct ThinnedBlow {
    ShapedSignal signal;
    double impulseChange = 0;  ///< relative to the impulse of all samples
    std::optional<double> corChange =
        {};                  ///< of e, where it was found: rods, and the uniform rod of a string
    bool isThinned = false;  ///< some samples were left out
};

/// Makes a blow of samples with as few points as keep impulse and e to `thinningError`, up to recipe.points.
/// The e of a string is that of its uniformRodOf(), which takes time. Requires samples without a problem.
ThinnedBlow thinnedBlow(const Scenario& scenario, const Samples& samples, const SignalRecipe& recipe,
                        const std::stop_token& stop = {});

}  // namespace drillwave
