// SPDX-License-Identifier: GPL-3.0-or-later
// Problem of a sequence of blows with its cells (time steps). Cones are divided into as many uniform pieces
// as the cells can resolve.
#pragma once

#include "core/model/scenario.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

/// Problem of a sequence of blows together with its grid of cells (time steps).
struct DrillingMesh {
    DrillingProblem problem;
    DrillingGrid grid;
};

/// Returns the problem and grid of a scenario for a number of cells per duration t0 of the hammer force (see
/// drillingGridOf()). Conical sections are divided into uniform pieces. Requires that drillingRefusals() is
/// empty.
DrillingMesh drillingMeshOf(const Scenario& scenario, int cellsPerDuration);
/// Returns the problem and grid for a comparison that estimates the error of the cells (see
/// comparedDrillingGridOf()). Conical sections have fewer pieces if the cells of that grid are larger, more
/// if they are smaller.
DrillingMesh comparedDrillingMeshOf(const Scenario& scenario, int cellsPerDuration);

}  // namespace drillwave
