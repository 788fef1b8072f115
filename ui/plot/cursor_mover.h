// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the cursors of a plot for the mouse and the keys.
#pragma once

#include <QPoint>
#include <optional>

#include "ui/plot/plot_cursors.h"

namespace drillwave {

class PlotWidget;

/// Mover of the cursors A, B and time of a plot. All pixels are in widget coordinates of the plot. Cursors
/// stay within the axes; the time cursor moves only if PlotWidget::offersTime().
class CursorMover {
  public:
    explicit CursorMover(PlotWidget& plot) : m_plot(plot) {}

    /// Returns the cursor within a few pixels of a point if the user may move it, else nothing.
    std::optional<PlotCursor> cursorAt(QPointF point) const;
    /// Returns the cursor at a point, as cursorAt(), and makes it the one that step() moves.
    std::optional<PlotCursor> grabAt(QPointF point);
    /// Moves a cursor to a horizontal position [px] on the plot; positions outside the axes are clamped.
    void drag(PlotCursor cursor, double pixel);
    /// Places a cursor at a point of the plot. Without a point, or with one outside the axes, the cursor is
    /// placed in the middle.
    void placeAt(PlotCursor cursor, std::optional<QPoint> at);
    /// Moves the cursor that was moved last by a number of pixels, positive to the right.
    void step(double pixels);

  private:
    QCPAxisRect* axesInUse() const;

    PlotWidget& m_plot;
    PlotCursor m_last = PlotCursor::a;
};

}  // namespace drillwave
