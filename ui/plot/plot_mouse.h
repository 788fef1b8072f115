// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and wheel control of a plot.
#pragma once

#include <QPointF>

#include "ui/plot/plot_cursors.h"

class QMouseEvent;
class QWheelEvent;

namespace drillwave {

class PlotWidget;

/// Receives the plot's events from the plot, which owns it: see PlotWidget for the gestures.
class PlotMouse {
  public:
    explicit PlotMouse(PlotWidget& plot) : m_plot(plot) {}

    void wheel(const QWheelEvent& event);
    /// Before and after the plot itself has taken note of a press: it draws the box.
    void beforePress(const QMouseEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);

  private:
    // The gesture between press and release.
    enum class Gesture { none, pan, box, cursor };

    void click(const QMouseEvent& event);
    void hover(QPointF point);
    void showPointer(Qt::CursorShape shape);

    PlotWidget& m_plot;
    Gesture m_gesture = Gesture::none;
    QPointF m_pressed;
    bool m_panning = false;  // moved already, not only pressed
    PlotCursor m_grabbed = PlotCursor::a;
    Qt::CursorShape m_pointer = Qt::ArrowCursor;
};

}  // namespace drillwave
