// SPDX-License-Identifier: GPL-3.0-or-later
// The layer of marks above a plot: cursors, crosses and labels at the pointer.
#pragma once

class QCustomPlot;

namespace drillwave {

/// Redraws only the layer "overlay" of a plot. Does nothing before the first replot of the plot, which draws
/// this layer too.
void redrawOverlay(QCustomPlot& plot);

}  // namespace drillwave
