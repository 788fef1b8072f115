// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of a plot.
#pragma once

#include <QMenu>
#include <QPoint>

class QCPAxis;

namespace drillwave {

class PlotWidget;

/// The menu of a point of the plot at this moment; deletes itself when it is closed.
class PlotMenu : public QMenu {
    Q_OBJECT

  public:
    PlotMenu(PlotWidget& plot, QPoint at);
};

/// Replaces the entries of another menu by the same ones, for a menu bar; call it when that menu opens.
void fillPlotMenu(QMenu& menu, PlotWidget& plot, QPoint at);

}  // namespace drillwave
