// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the paper that show results, recomputed by the program.
#pragma once

#include <stop_token>
#include <vector>

#include "core/study/paper/figure_data.h"

namespace drillwave {

/// Numbers of the first and the last figure of the paper that the program recomputes.
inline constexpr int firstPaperFigure = 3, lastPaperFigure = 8;

// Each figure is drawn as in the paper, with dimensionless values from the exact solution.

/// Returns Figure 3 of the paper: waves at the middle of the rod over time.
Figure figure3();
/// Returns Figure 4 of the paper: impact force, impulse and momentum over time.
Figure figure4();
/// Returns Figure 5 of the paper: the two peaks of the impact force over time, exact and from the
/// closed-form approximation. Time is counted from the arrival of the wave that causes the peak.
Figure figure5();
/// Returns Figure 6 of the paper: coefficient of restitution e over the stiffness β. The reference case (rod
/// without waves) is shown with both reference stiffnesses in ReferenceStiffness.
Figure figure6();
/// Returns Figure 7 of the paper: coefficient of restitution e over the stiffness β, exact and from the
/// closed-form approximation, and the terms that this approximation neglects.
Figure figure7();
/// Returns Figure 8 of the paper: coefficient of restitution e over one period of the gap. The reference
/// case (rod without waves) is shown with both reference stiffnesses in ReferenceStiffness.
Figure figure8();

/// Returns the figure of the paper with a number from firstPaperFigure (3) to lastPaperFigure (8).
Figure paperFigure(int number);

/// Returns Figures 3 … 8 of the paper in order; fewer if a stop is requested.
std::vector<Figure> paperFigures(std::stop_token stop = {});

}  // namespace drillwave
