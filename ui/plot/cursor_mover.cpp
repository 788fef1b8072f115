// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_mover.h"

#include <algorithm>

#include "ui/plot/plot_widget.h"

namespace drillwave {

// Returns the axes that map pixels to times: those used last, or the first with graphs.
QCPAxisRect* CursorMover::axesInUse() const {
    const QList<QCPAxisRect*> rects = m_plot.reader().cursors().rects();
    QCPAxisRect* active = m_plot.view().activeRect();
    return rects.contains(active) ? active : rects.value(0);
}

std::optional<PlotCursor> CursorMover::cursorAt(QPointF point) const {
    const std::optional<PlotCursor> cursor = m_plot.reader().cursors().cursorAt(point);
    return cursor == PlotCursor::time && !m_plot.offersTime() ? std::nullopt : cursor;
}

std::optional<PlotCursor> CursorMover::grabAt(QPointF point) {
    const std::optional<PlotCursor> cursor = cursorAt(point);
    if (cursor) m_last = *cursor;
    return cursor;
}

void CursorMover::drag(PlotCursor cursor, double pixel) {
    const QCPAxisRect* on = axesInUse();
    if (!on) return;
    const double kept = std::clamp<double>(pixel, on->rect().left(), on->rect().right());
    const double x = on->axis(QCPAxis::atBottom)->pixelToCoord(kept);
    m_last = cursor;
    m_plot.reader().place(cursor, x);
    if (cursor == PlotCursor::time) emit m_plot.timeCursorDragged(x);
}

void CursorMover::placeAt(PlotCursor cursor, std::optional<QPoint> at) {
    if (cursor == PlotCursor::time && !m_plot.offersTime()) return;
    if (at) m_plot.view().activateAt(*at);
    if (at && cursor != PlotCursor::time) m_plot.reader().aim(*at);
    const QCPAxisRect* on = axesInUse();
    if (!on) return;
    const bool beside = !at || at->x() < on->rect().left() || at->x() > on->rect().right();
    drag(cursor, beside ? on->rect().center().x() : at->x());
}

void CursorMover::step(double pixels) {
    const std::optional<double> x = m_plot.reader().position(m_last);
    const QCPAxisRect* on = axesInUse();
    if (x && on) drag(m_last, on->axis(QCPAxis::atBottom)->coordToPixel(*x) + pixels);
}

}  // namespace drillwave
