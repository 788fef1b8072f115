// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of the rows of a sweep into curves.
#pragma once

#include <vector>

#include "core/study/paper/figure_data.h"
#include "core/study/rows/sweep_rows.h"

namespace drillwave {

/// Returns one panel of curves for each output of a sweep. The horizontal axis is the parameter with the most
/// values; each value of the other parameter has a curve. A row that was not solved leaves a gap. Requires
/// that pictureProblem() is empty.
std::vector<FigurePanel> sweepPanels(const SweepRows& rows);

}  // namespace drillwave
