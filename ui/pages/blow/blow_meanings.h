// SPDX-License-Identifier: GPL-3.0-or-later
// Exact functions and units of the curves of a blow.
#pragma once

#include <array>

#include "ui/job/solved_blow.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Units and exact functions of the curves in BlowPlots, from which the cursors read values. Forces have
/// exact values and integrals; integrals are shown as impulses ("N s", "I₀"). Impulse and momentum have exact
/// values only. The functions share ownership of the blow, so that they stay valid.
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

/// Returns the units of a curve of force over time, such as a measured or approximate one. It has no exact
/// function; the cursors read its drawn points.
CurveMeaning forceMeaning(const ShownUnits& units);

/// Returns, for each curve of a solved blow, its units and its exact function, which the cursors read.
/// Requires that the blow contains page data of type BlowCurves.
BlowMeanings blowMeanings(const SolvedBlowPtr& blow);

}  // namespace drillwave
