// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of a plot.
#pragma once

#include <QMenu>
#include <QPoint>

class QCPAxis;

namespace drillwave {

class PlotWidget;

/// For a point of the plot, as it is now; deletes itself when it is closed.
class PlotMenu : public QMenu {
    Q_OBJECT

  public:
    PlotMenu(PlotWidget& plot, QPoint at);
};

/// The same entries in another menu, which they are to replace when it opens: those of a menu bar.
void fillPlotMenu(QMenu& menu, PlotWidget& plot, QPoint at);

}  // namespace drillwave
