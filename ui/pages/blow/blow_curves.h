// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of one blow as ready plot data, built away from the window's thread.
#pragma once

#include <array>
#include <optional>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"
#include "ui/pages/blow/closed_form_curve.h"
#include "ui/plot/graph_data.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// What the four plots of a blow show (paper, Figs. 3–5), times global, in the units of `units`.
struct BlowCurves {
    static constexpr int waveCount = 4;

    ShownUnits units;
    double section = 0.5;                           ///< x/L of the waves
    std::array<GraphData, waveCount> waves;         ///< N0p, N1n, N2p, N3n, each over its own interval
    std::array<GraphData, 2> laterWaves;            ///< N4p, N6p … and N5n, N7n …, up to timeEnd
    GraphData sectionForce;                         ///< N there: the sum of all waves, up to timeEnd
    GraphData force;                                ///< impact force
    GraphData impulse;                              ///< of the impact force so far
    GraphData momentum;                             ///< of the rod, positive towards the rock
    std::optional<ClosedFormCurve> closedForm;      ///< where it is wanted and holds
    double timeEnd = 0;                             ///< until then something happens; the curves may go on
    std::vector<RunOverlay<BlowCurves>> runs = {};  ///< laid over them
};

/// Requires an impact solved with Detail::histories.
BlowCurves blowCurves(const Impact& impact, const PulseForce& pulse, const ShownUnits& units, double section,
                      Tail tail = Tail::kept);

}  // namespace drillwave
