// SPDX-License-Identifier: GPL-3.0-or-later
// The layer of marks that lie over a plot: cursors, crosses, what is read below the pointer.
#pragma once

class QCustomPlot;

namespace drillwave {

/// Redraws only the overlay of the plot. One that has not been drawn yet is drawn with all else.
void redrawOverlay(QCustomPlot& plot);

}  // namespace drillwave
