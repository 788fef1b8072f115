// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a sweep as curves.
#pragma once

#include <vector>

#include "core/study/paper/figure_data.h"
#include "core/study/rows/sweep_rows.h"

namespace drillwave {

/// A panel for each output: curves along the lineAxis(), one for each value of the other axis. A row that was
/// not solved is a gap in its curve. Requires pictureProblem() to be empty.
std::vector<FigurePanel> sweepPanels(const SweepRows& rows);

}  // namespace drillwave
