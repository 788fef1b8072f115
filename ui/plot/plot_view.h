// SPDX-License-Identifier: GPL-3.0-or-later
// View of a plot (its axis ranges), and the ways in which the user changes it.
#pragma once

#include <QPointer>
#include <QVector>

#include "ui/plot/view_history.h"

namespace drillwave {

/// View of a plot: zooming, panning, scales and the way back to earlier views. Points and distances are in
/// pixels of the plot; each step redraws it.
class PlotView {
  public:
    explicit PlotView(QCustomPlot& plot) : m_plot(plot), m_history(plot) {}

    /// Returns the axis rect used last, which the keys act on. At first it is the first one; nullptr if the
    /// plot has none.
    QCPAxisRect* activeRect() const;
    /// Makes the axis rect at a point the active one, on which the keys act. Does nothing if no axis rect is
    /// there.
    void activateAt(QPointF point);
    /// Returns whether a point is between the axes of the axis rect used last; false before one has been
    /// used.
    bool isInside(QPointF point) const;
    /// Returns the axes that a wheel turn or drag at this point acts on: the axis below it, or both axes of
    /// the rect.
    QList<QCPAxis*> axesAt(QPointF point) const;

    /// Zooms the axes at a point by `factor` (less than 1 zooms in), keeping the values at the point. Returns
    /// false if no axis is there.
    bool zoomAt(QPointF point, double factor);
    /// Zooms the active axis rect by `factor` (less than 1 zooms in) around its middle.
    void zoom(double factor);
    /// Moves the curves of the active axis rect by a share of its width or height, positive to the right or
    /// down.
    void pan(Qt::Orientation orientation, double share);
    /// Starts a drag at the point `from`. Nothing moves before the first dragTo().
    void beginDrag(QPointF from);
    /// Moves the curves so that the values that were at the start of the drag are at `to`.
    void dragTo(QPointF to);
    void endDrag() { m_dragged.clear(); }
    /// Zooms the active axis rect to a box that the user has drawn. Boxes smaller than 6 px are ignored.
    void zoomTo(const QRect& drawn);

    /// Sets an axis linear or logarithmic, as one step that goBack() reverts. A horizontal axis of one of the
    /// rects in `stacked` takes the horizontal axes of all of them along.
    void setScale(QCPAxis* axis, QCPAxis::ScaleType scale, const QList<QCPAxisRect*>& stacked);
    /// Saves the present view for goBack(). Call this before changing the view by other means.
    void remember() { m_history.remember(); }
    bool canGoBack() const { return m_history.canGoBack(); }
    /// Returns to the last saved view that differs from the present one.
    void goBack();
    /// Fits all logarithmic axes to the positive values of their curves; pages fit only linear axes.
    void fitLogarithms();

  private:
    struct DraggedAxis {
        QPointer<QCPAxis> axis;
        QCPRange start;
    };

    QCustomPlot& m_plot;
    ViewHistory m_history;
    QPointer<QCPAxisRect> m_active;
    QPointF m_dragStart;
    QVector<DraggedAxis> m_dragged;
    bool m_dragging = false;  // whether the pointer has moved since beginDrag()
};

}  // namespace drillwave
