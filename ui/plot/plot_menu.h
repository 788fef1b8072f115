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

  private:
    void addCopyAndSave();
    void addView();
    void addScale(QCPAxis* axis, const QString& text);
    void addCurves();
    void addCursors();

    PlotWidget& m_plot;
    QPoint m_at;
};

}  // namespace drillwave
