// SPDX-License-Identifier: GPL-3.0-or-later
// A measured blow by as few points as a stated error allows: solving takes as long as its points are many.
#pragma once

#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/signal/samples.h"
#include "core/signal/signal_recipe.h"

namespace drillwave {

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
/// The e of a string is that of uniformRodOf() it, which takes its time. Requires samples without a problem.
ThinnedBlow thinnedBlow(const Scenario& scenario, const Samples& samples, const SignalRecipe& recipe,
                        const std::stop_token& stop = {});

}  // namespace drillwave
