// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the paper that show results, computed by this program.
#pragma once

#include <stop_token>
#include <vector>

#include "core/study/paper/figure_data.h"

namespace drillwave {

/// First and last number of these figures in the paper.
inline constexpr int firstPaperFigure = 3, lastPaperFigure = 8;

// Each as the paper draws it, dimensionless, from the exact solution.

/// Waves at the mid-section.
Figure figure3();
/// Impact force, impulse and momentum.
Figure figure4();
/// The two peaks of the impact force beside the closed form, in local time.
Figure figure5();
/// COR over the stiffness, with the reference case in both normalisations.
Figure figure6();
/// COR over the stiffness with the closed form, and what that neglects.
Figure figure7();
/// COR over one period of the gap, with the reference case in both normalisations.
Figure figure8();

/// Returns the figure of a number, 3 … 8.
Figure paperFigure(int number);

/// Returns all figures; fewer if a stop is requested.
std::vector<Figure> paperFigures(std::stop_token stop = {});

}  // namespace drillwave
