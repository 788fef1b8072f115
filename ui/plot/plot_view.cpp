// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_view.h"

#include "ui/plot/axis_view.h"

namespace drillwave {
namespace {

constexpr int leastBox = 6;  // [px]

double sideCenter(const QCPAxis& axis) {
    const QRect rect = axis.axisRect()->rect();
    return axis.orientation() == Qt::Horizontal ? rect.center().x() : rect.center().y();
}

double along(const QCPAxis& axis, QPointF point) {
    return axis.orientation() == Qt::Horizontal ? point.x() : point.y();
}

QList<QCPAxis*> bothAxes(const QCPAxisRect& rect) {
    QList<QCPAxis*> axes;
    for (const auto type : {QCPAxis::atBottom, QCPAxis::atLeft})
        if (QCPAxis* axis = rect.axis(type)) axes.append(axis);
    return axes;
}

}  // namespace

QCPAxisRect* PlotView::activeRect() const {
    if (m_active) return m_active;
    return m_plot.axisRectCount() > 0 ? m_plot.axisRect(0) : nullptr;
}

void PlotView::activateAt(QPointF point) {
    if (QCPAxisRect* below = m_plot.axisRectAt(point)) m_active = below;
}

bool PlotView::isInside(QPointF point) const {
    return m_active && m_active->rect().contains(point.toPoint());
}

QList<QCPAxis*> PlotView::axesAt(QPointF point) const {
    QList<QCPAxis*> axes;
    for (const QCPAxisRect* rect : m_plot.axisRects())
        for (QCPAxis* axis : bothAxes(*rect))
            if (axis->selectTest(point, false) >= 0) axes.append(axis);
    if (!axes.isEmpty()) return axes;
    const QCPAxisRect* rect = m_plot.axisRectAt(point);
    if (!rect || !rect->rect().contains(point.toPoint())) return {};
    return bothAxes(*rect);
}

bool PlotView::zoomAt(QPointF point, double factor) {
    const QList<QCPAxis*> axes = axesAt(point);
    if (axes.isEmpty()) return false;
    activateAt(point);
    m_history.rememberBurst();
    for (QCPAxis* axis : axes) zoomAxis(*axis, factor, along(*axis, point));
    m_plot.replot(QCustomPlot::rpQueuedReplot);
    return true;
}

void PlotView::zoom(double factor) {
    if (!activeRect()) return;
    m_history.rememberBurst();
    for (QCPAxis* axis : bothAxes(*activeRect())) zoomAxis(*axis, factor, sideCenter(*axis));
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

void PlotView::pan(Qt::Orientation orientation, double share) {
    if (!activeRect()) return;
    const bool horizontal = orientation == Qt::Horizontal;
    QCPAxis* axis = activeRect()->axis(horizontal ? QCPAxis::atBottom : QCPAxis::atLeft);
    const QRect rect = activeRect()->rect();
    const double shift = share * (horizontal ? rect.width() : rect.height());
    m_history.rememberBurst();
    panAxis(*axis, axis->range(), sideCenter(*axis), sideCenter(*axis) + shift);
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

void PlotView::beginDrag(QPointF from) {
    m_dragged.clear();
    m_dragging = false;
    m_dragStart = from;
    for (QCPAxis* axis : axesAt(from)) m_dragged.append({axis, axis->range()});
}

void PlotView::dragTo(QPointF to) {
    if (!std::exchange(m_dragging, true)) m_history.remember();
    for (const DraggedAxis& dragged : m_dragged)
        if (dragged.axis)
            panAxis(*dragged.axis, dragged.start, along(*dragged.axis, m_dragStart),
                    along(*dragged.axis, to));
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

void PlotView::zoomTo(const QRect& drawn) {
    const QRect box = drawn.normalized();
    if (!m_active || box.width() < leastBox || box.height() < leastBox) return;
    m_history.remember();
    const QRect inside = box & m_active->rect();
    zoomAxisTo(*m_active->axis(QCPAxis::atBottom), inside.left(), inside.right());
    zoomAxisTo(*m_active->axis(QCPAxis::atLeft), inside.top(), inside.bottom());
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

void PlotView::setScale(QCPAxis* axis, QCPAxis::ScaleType scale, const QList<QCPAxisRect*>& stacked) {
    m_history.remember();
    QList<QCPAxis*> axes{axis};
    if (axis->orientation() == Qt::Horizontal && stacked.contains(axis->axisRect())) {
        axes.clear();
        for (const QCPAxisRect* rect : stacked) axes.append(rect->axis(axis->axisType()));
    }
    for (QCPAxis* changed : axes) drillwave::setScale(*changed, scale);
}

void PlotView::goBack() {
    m_history.goBack();
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

void PlotView::fitLogarithms() {
    for (const QCPAxisRect* rect : m_plot.axisRects())
        for (QCPAxis* axis : bothAxes(*rect)) fitLogarithmic(*axis);
}

}  // namespace drillwave
