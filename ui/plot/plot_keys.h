// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard control of a plot.
#pragma once

#include <QObject>

class QKeyEvent;

namespace drillwave {

class PlotWidget;

/// Lives as a child of the plot: see PlotWidget for what the keys do.
class PlotKeys : public QObject {
    Q_OBJECT

  public:
    explicit PlotKeys(PlotWidget& plot);

    /// Whether the key means something here; it is done then.
    bool press(const QKeyEvent& event);
    /// While the pointer is over the plot some keys go there wherever the focus is.
    void followPointer(bool isHere);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool pointKey(const QKeyEvent& event);
    bool cursorKey(const QKeyEvent& event);
    bool viewKey(const QKeyEvent& event);
    bool arrowKey(int key);

    PlotWidget& m_plot;
};

}  // namespace drillwave
