// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the cursors of a plot for the mouse and the keys.
#pragma once

#include <QPoint>
#include <optional>

#include "ui/plot/plot_cursors.h"

namespace drillwave {

class PlotWidget;

/// Controls for moving the vertical cursor lines A, B and time of a plot by mouse or keys. All positions are
/// pixels of the plot widget. Cursors stay within the axes. The time cursor moves only if
/// PlotWidget::offersTime().
class CursorMover {
  public:
    explicit CursorMover(PlotWidget& plot) : m_plot(plot) {}

    /// Returns the cursor within a few pixels of a point; nothing if there is none, or if the user must not
    /// move it.
    std::optional<PlotCursor> cursorAt(QPointF point) const;
    /// Returns the cursor at a point, as cursorAt() does. If there is one, step() moves this cursor from now
    /// on.
    std::optional<PlotCursor> grabAt(QPointF point);
    /// Moves a cursor to the horizontal position `pixel` of the plot. Positions to the left or right of the
    /// axes give the nearer edge.
    void drag(PlotCursor cursor, double pixel);
    /// Places a cursor at the x of a point of the plot. Without a point, or with one to the left or right of
    /// the axes, it is placed in the middle.
    void placeAt(PlotCursor cursor, std::optional<QPoint> at);
    /// Moves the cursor that the user placed or dragged last by `pixels`, positive to the right.
    void step(double pixels);

  private:
    QCPAxisRect* axesInUse() const;

    PlotWidget& m_plot;
    PlotCursor m_last = PlotCursor::a;
};

}  // namespace drillwave
