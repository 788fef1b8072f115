// SPDX-License-Identifier: GPL-3.0-or-later
// View of a plot (its axis ranges), and the ways in which the user changes it.
#pragma once

#include <QPointer>
#include <QVector>

#include "ui/plot/view_history.h"

namespace drillwave {

/// View of a plot: zooming, panning, scales and the way back to earlier views. Points and distances are in
/// pixels of the plot. Each change of the view redraws the plot.
class PlotView {
  public:
    explicit PlotView(QCustomPlot& plot) : m_plot(plot), m_history(plot) {}

    /// Returns the axis rect used last, on which the keys act. It is the first rect until the user has used
    /// one; nullptr if the plot has none.
    QCPAxisRect* activeRect() const;
    /// Makes the axis rect at a point the active one, on which keys for zooming and panning act. Does nothing
    /// if no axis rect is there.
    void activateAt(QPointF point);
    /// Returns whether a point is between the axes of the axis rect used last. False if no axis rect has been
    /// used yet.
    bool isInside(QPointF point) const;
    /// Returns the axes that a turn of the wheel or a drag at this point changes. If the point is on an axis,
    /// it is only this axis; between the axes it is both.
    QList<QCPAxis*> axesAt(QPointF point) const;

    /// Zooms the axes at a point by `factor` (less than 1 zooms in). The values at the point stay where they
    /// are. Returns false if no axis is there.
    bool zoomAt(QPointF point, double factor);
    /// Zooms the active axis rect by `factor` (less than 1 zooms in) around its middle.
    void zoom(double factor);
    /// Pans the axis rect used last along one axis. The curves move by `share` of the rect's width
    /// (horizontal) or height (vertical); positive is to the right or down.
    void pan(Qt::Orientation orientation, double share);
    /// Starts a drag with the mouse at the point `from`. The view does not change before the first dragTo().
    void beginDrag(QPointF from);
    /// Pans the axes so that the point of the plot that was under the pointer at beginDrag() is now at `to`.
    void dragTo(QPointF to);
    void endDrag() { m_dragged.clear(); }
    /// Zooms the active axis rect to a box that the user has drawn. Boxes smaller than 6 px are ignored.
    void zoomTo(const QRect& drawn);

    /// Makes an axis linear or logarithmic, as one step that goBack() reverts. If it is the horizontal axis
    /// of a rect in `stacked`, the horizontal axes of all these rects change with it.
    void setScale(QCPAxis* axis, QCPAxis::ScaleType scale, const QList<QCPAxisRect*>& stacked);
    /// Saves the present view, so that goBack() can restore it. Call this before changing axis ranges without
    /// this class.
    void remember() { m_history.remember(); }
    bool canGoBack() const { return m_history.canGoBack(); }
    /// Returns to the last saved view that differs from the present one.
    void goBack();
    /// Fits all logarithmic axes to the positive values of their curves. Called after the page has fitted the
    /// linear axes.
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
