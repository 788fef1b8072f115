// SPDX-License-Identifier: GPL-3.0-or-later
// A march and its cells: a cone is so many uniform pieces as the cells can tell apart.
#pragma once

#include "core/model/scenario.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

struct DrillingMesh {
    DrillingProblem problem;
    DrillingGrid grid;
};

/// drillingGridOf() with the cones of the scenario in pieces. Requires that there are no drillingRefusals().
DrillingMesh drillingMeshOf(const Scenario& scenario, int cellsPerDuration);
/// comparedDrillingGridOf(): a cone has fewer pieces where cells are larger, and more where they are smaller.
DrillingMesh comparedDrillingMeshOf(const Scenario& scenario, int cellsPerDuration);

}  // namespace drillwave
