// SPDX-License-Identifier: GPL-3.0-or-later
// View of a plot, and the ways in which a user moves it.
#pragma once

#include <QPointer>
#include <QVector>

#include "ui/plot/view_history.h"

namespace drillwave {

/// Every step can be taken back. Points and distances are in pixels of the plot; each step redraws it.
class PlotView {
  public:
    explicit PlotView(QCustomPlot& plot) : m_plot(plot), m_history(plot) {}

    /// The axis rect used last, which keys act on; at first the first one. nullptr where there is none.
    QCPAxisRect* activeRect() const;
    /// The rect below a point, if there is one, is used from now on.
    void activateAt(QPointF point);
    /// Whether the point is between the axes of a rect that has been used.
    bool isInside(QPointF point) const;
    /// Returns the axes that a wheel or drag at this point acts on: the axis below it, or both of the rect.
    QList<QCPAxis*> axesAt(QPointF point) const;

    /// Changes the ranges at a point by `factor` (less than 1 zooms in) around it; false where there is no
    /// axis.
    bool zoomAt(QPointF point, double factor);
    /// Changes the ranges in the same way around the middle of the active rect.
    void zoom(double factor);
    /// Moves the active rect's view by a share of its size.
    void pan(Qt::Orientation orientation, double share);
    /// Drags what was at `from` along, from the first dragTo() on.
    void beginDrag(QPointF from);
    void dragTo(QPointF to);
    void endDrag() { m_dragged.clear(); }
    /// Shows what is in a box of the active rect.
    void zoomTo(const QRect& drawn);

    /// A step of its own: linear or logarithmic; a horizontal axis together with those of `stacked`, when it
    /// is one of theirs.
    void setScale(QCPAxis* axis, QCPAxis::ScaleType scale, const QList<QCPAxisRect*>& stacked);
    /// Keeps the present view to go back to; call before it changes otherwise.
    void remember() { m_history.remember(); }
    bool canGoBack() const { return m_history.canGoBack(); }
    void goBack();
    /// Fits what no page does: logarithmic axes.
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
    bool m_dragging = false;  // moved already
};

}  // namespace drillwave
