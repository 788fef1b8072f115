// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of one blow as ready plot data, built away from the window's thread.
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "core/blow/blow.h"
#include "core/blow/blow_waves.h"
#include "ui/pages/blow/closed_form_curve.h"
#include "ui/plot/graph_data.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Data of the four plots of a blow (paper, Figs. 3–5), times global, in the units of `units`.
struct BlowCurves {
    static constexpr int waveCount = 4;

    ShownUnits units;
    double section = 0.5;                           ///< x/L of the waves
    std::array<GraphData, waveCount> waves;         ///< N0p, N1n, N2p, N3n, each over its own interval
    std::array<GraphData, 2> laterWaves;            ///< N4p, N6p … and N5n, N7n …, up to timeEnd
    GraphData sectionForce;                         ///< N there: the sum of all waves, up to timeEnd
    std::optional<StringPlace> place;               ///< where in a drill string that is: then the first two
                                                    ///< waves are Np and Nn, and there are no others
    QString sectionWords;                           ///< of a string: "2nd rod", "hammer 1"
    double fromRear = 0;                            ///< [m]
    GraphData force;                                ///< impact force
    GraphData faceForce = {};                       ///< of hammer and string
    GraphData impulse;                              ///< of the impact force so far
    GraphData momentum;                             ///< of the rod, positive towards the rock
    std::optional<ClosedFormCurve> closedForm;      ///< where it is wanted and holds
    double timeEnd = 0;                             ///< until then something happens; the curves may go on
    std::vector<RunOverlay<BlowCurves>> runs = {};  ///< laid over them
};

/// No curves where the histories were not kept.
BlowCurves blowCurves(const Blow& blow, const ShownUnits& units, double section, Tail tail = Tail::kept);

}  // namespace drillwave
