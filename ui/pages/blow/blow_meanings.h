// SPDX-License-Identifier: GPL-3.0-or-later
// Exact functions and units of the curves of a blow.
#pragma once

#include <array>

#include "ui/job/solved_blow.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Meanings of the graphs of BlowPlots. The functions share the blow, so they may outlive everything else.
/// Forces have exact values and integrals, the latter as impulses ("N s", "I₀"); impulse and momentum have
/// exact values.
struct BlowMeanings {
    std::array<CurveMeaning, BlowCurves::waveCount> waves;
    std::array<CurveMeaning, 2> laterWaves;
    CurveMeaning sectionForce;
    CurveMeaning force;
    CurveMeaning closedForm;
    CurveMeaning faceForce;
    CurveMeaning impulse;
    CurveMeaning momentum;
};

/// Returns the meaning of a force over time that has only the points of its curve, no exact function.
CurveMeaning forceMeaning(const ShownUnits& units);

/// Requires a solved blow with its curves.
BlowMeanings blowMeanings(const SolvedBlowPtr& blow);

}  // namespace drillwave
