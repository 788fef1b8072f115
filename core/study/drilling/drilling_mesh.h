// SPDX-License-Identifier: GPL-3.0-or-later
// Problem of a sequence of blows with its cells (time steps). Cones are divided into as many uniform pieces
// as the cells can resolve.
#pragma once

#include "core/model/scenario.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

/// Dimensionless problem of a sequence of blows together with its grid, the division of time into cells (time
/// steps).
struct DrillingMesh {
    DrillingProblem problem;
    DrillingGrid grid;
};

/// Returns the dimensionless problem and the grid of a scenario. `cellsPerDuration` is the number of cells
/// (time steps) per duration t0 of the hammer force (see drillingGridOf()). Conical sections are divided into
/// uniform pieces. Requires that drillingRefusals() is empty.
DrillingMesh drillingMeshOf(const Scenario& scenario, int cellsPerDuration);
/// Returns the problem and grid with another time step (cell), to estimate the error that the time step of
/// drillingMeshOf() causes. The grid is that of comparedDrillingGridOf(). Conical sections have fewer uniform
/// pieces if the time step is larger, more if it is smaller.
DrillingMesh comparedDrillingMeshOf(const Scenario& scenario, int cellsPerDuration);

}  // namespace drillwave
