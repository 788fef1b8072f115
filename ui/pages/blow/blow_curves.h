// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of one blow as data of plots, computed outside the window's thread.
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

/// Data of the four plots of a blow (paper, Figs. 3–5): waves, impact force, impulse and momentum over time.
/// Times count from the impact of the hammer. All values are in the units of `units`.
struct BlowCurves {
    static constexpr int waveCount = 4;

    ShownUnits units;
    /// Position x/L where the waves are observed; negative in the hammer.
    double section = 0.5;
    std::array<GraphData, waveCount> waves;  ///< N0p, N1n, N2p and N3n of a rod, each over its own time
    /// Sums of the later waves of a rod up to timeEnd: N4p, N6p … towards the bit, then N5n, N7n … from the
    /// bit.
    std::array<GraphData, 2> laterWaves;
    GraphData sectionForce;  ///< N at the section, the sum of all waves, up to timeEnd
    /// Observed position in a drill string; empty for a uniform rod. In a drill string the first two waves
    /// are the sums of all waves towards the bit (Np) and from it (Nn). The others are empty.
    std::optional<StringPlace> place;
    /// Name of the observed section of a drill string, such as "2nd rod" or "hammer 1".
    QString sectionWords;
    /// Distance of the observed position from the rear end of its section of the drill string [m].
    double fromRear = 0;
    GraphData force;           ///< impact force on the rock, in the unit units.force
    GraphData faceForce = {};  ///< force between hammer and drill string; empty for a uniform rod
    GraphData impulse;         ///< impulse of the impact force up to each time, in units.impulse
    /// Momentum of rod or drill string in units.impulse, positive towards the rock.
    GraphData momentum;
    /// Impact force by the paper's closed form (analytical solution); empty if it is not wanted or not valid.
    std::optional<ClosedFormCurve> closedForm;
    /// End of the default plot range, in units.time; curves may be longer.
    double timeEnd = 0;
    std::vector<RunOverlay<BlowCurves>> runs = {};  ///< curves of pinned runs (results kept for comparison)
};

/// Returns the curves of a blow, with the waves at the position x/L = `section`. They are empty if the blow
/// was solved without time histories.
BlowCurves blowCurves(const Blow& blow, const ShownUnits& units, double section, Tail tail = Tail::kept);

}  // namespace drillwave
