// SPDX-License-Identifier: GPL-3.0-or-later
// The place of the present scenario in a map, which the mouse can drag.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// A ring with a vertical and a horizontal line through it, which go on through the rects below and beside.
/// The mouse drags the ring, both parameters at once, or one of the lines; Ctrl with the arrow keys moves it
/// by a two-hundredth of the view while the plot has the focus. On the overlay layer. Lives as a child of the
/// plot.
class MapCrosshair : public QObject {
    Q_OBJECT

  public:
    MapCrosshair(QCustomPlot* plot, QCPAxisRect* map, QCPAxisRect* below, QCPAxisRect* beside);

    /// Moves it, in units of the axes, or hides it. Replots only the overlay layer, and only after a change.
    void setPlace(const std::optional<QPointF>& place);
    const std::optional<QPointF>& place() const { return m_place; }
    void setStyle(const PlotStyle& style);

  signals:
    /// A drag begins, moves within the view, and has ended. A key is a drag of one step.
    void dragStarted();
    void dragged(QPointF place);
    void dragEnded();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Part { none, x, y, both };
    Part partAt(QPointF at) const;
    QPointF pixel() const;
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release();
    bool step(const QKeyEvent& event);
    void moveTo(QPointF to);

    QCustomPlot* m_plot;
    QCPAxisRect* m_map;
    QCPItemStraightLine* m_lines[4];  // through the map across and up, below up, beside across
    QCPItemTracer* m_halo;
    QCPItemTracer* m_ring;
    std::optional<QPointF> m_place;
    Part m_dragged = Part::none;
    bool m_ownsPointer = false;  // the mouse pointer shows that something can be dragged
};

}  // namespace drillwave
