// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and wheel control of a plot.
#pragma once

#include <QPointF>

#include "ui/plot/plot_cursors.h"

class QMouseEvent;
class QWheelEvent;

namespace drillwave {

class PlotWidget;

/// Handler of the mouse events of one plot. The plot owns it and passes its mouse events to it. All gestures
/// are listed in the comment of PlotWidget.
class PlotMouse {
  public:
    explicit PlotMouse(PlotWidget& plot) : m_plot(plot) {}

    void wheel(const QWheelEvent& event);
    /// Handles a press of a mouse button before QCustomPlot does. Switches on the selection box if this press
    /// starts one.
    void beforePress(const QMouseEvent& event);
    /// Handles a press of a mouse button after QCustomPlot has: grabs a cursor, starts panning, or goes back
    /// to the previous view.
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
    bool m_panning = false;  // whether the pointer has moved far enough to pan
    PlotCursor m_grabbed = PlotCursor::a;
    Qt::CursorShape m_pointer = Qt::ArrowCursor;
};

}  // namespace drillwave
