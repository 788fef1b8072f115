// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of a plot.
#pragma once

#include <QMenu>
#include <QPoint>

class QCPAxis;

namespace drillwave {

class PlotWidget;

/// Context menu of a plot, opened at the point `at` [px]. It copies and saves the plot, changes its view,
/// shows curves and places cursors. It deletes itself when it is closed.
class PlotMenu : public QMenu {
    Q_OBJECT

  public:
    PlotMenu(PlotWidget& plot, QPoint at);
};

/// Replaces the entries of `menu`, a menu of the menu bar, by those of the context menu of the plot at a
/// point [px]. Call this when the menu is about to open.
void fillPlotMenu(QMenu& menu, PlotWidget& plot, QPoint at);

}  // namespace drillwave
