// SPDX-License-Identifier: GPL-3.0-or-later
// What it does to e that of a measured blow some samples alone are kept.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/signal/samples.h"
#include "core/signal/signal_recipe.h"

namespace drillwave {

/// More samples are not followed: those of the longest table of a scenario.
inline constexpr std::size_t mostSamplesFollowed = 100'000;

struct ThinningEffect {
    double cor = 0;     ///< of the points that are kept
    double change = 0;  ///< that less the e of all samples, or of mostSamplesFollowed of them
    double error = 0;   ///< bound on the numerical error of the change
};

/// Solves the blow that a recipe makes of samples, on the rod and the rock of a scenario, by the points that
/// `kept` has and by all samples. Nothing where no sample was left out, for a drill string, which is not
/// struck by a force, where one of both is no valid blow or is not solved, and on a stop.
std::optional<ThinningEffect> thinningEffect(const Scenario& scenario, const Samples& samples,
                                             const SignalRecipe& recipe, const ShapedSignal& kept,
                                             const std::stop_token& stop = {});

}  // namespace drillwave
