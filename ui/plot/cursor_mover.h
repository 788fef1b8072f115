// SPDX-License-Identifier: GPL-3.0-or-later
// The cursors of a plot moved by its user.
#pragma once

#include <QPoint>
#include <optional>

#include "ui/plot/plot_cursors.h"

namespace drillwave {

class PlotWidget;

/// Pixels are those of the plot. Cursors stay within the axes; the time moves only where the plot offers it.
class CursorMover {
  public:
    explicit CursorMover(PlotWidget& plot) : m_plot(plot) {}

    /// The cursor below a point that may be moved.
    std::optional<PlotCursor> cursorAt(QPointF point) const;
    /// Takes up the cursor at a point, if there is one: stepping moves it from now on.
    std::optional<PlotCursor> grabAt(QPointF point);
    void drag(PlotCursor cursor, double pixel);
    /// Puts a cursor at a point, or in the middle if there is none or it is beside the axes.
    void placeAt(PlotCursor cursor, std::optional<QPoint> at);
    /// Moves the cursor that was moved last.
    void step(double pixels);

  private:
    QCPAxisRect* axesInUse() const;

    PlotWidget& m_plot;
    PlotCursor m_last = PlotCursor::a;
};

}  // namespace drillwave
