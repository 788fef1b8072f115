// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cross_mark.h"

#include "ui/plot/overlay.h"

namespace drillwave {

void CrossMark::addLines(QCPAxisRect& rect) {
    for (QPointer<QCPItemTracer>& lines : m_lines) {
        lines = new QCPItemTracer(&m_plot);
        lines->setLayer(QStringLiteral("overlay"));
        lines->setSelectable(false);
        lines->setAntialiased(false);
        lines->setStyle(QCPItemTracer::tsCrosshair);
        lines->setClipAxisRect(&rect);
        lines->position->setAxisRect(&rect);
        lines->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
        lines->position->setType(QCPItemPosition::ptPlotCoords);
    }
    setStyle(m_style);
}

void CrossMark::show(QCPAxisRect& rect, QPointF place, const QString& text) {
    if (!m_lines.back()) addLines(rect);
    for (const QPointer<QCPItemTracer>& lines : m_lines) {
        lines->position->setCoords(place);
        lines->setVisible(true);
    }
    m_mark.show(rect,
                {rect.axis(QCPAxis::atBottom)->coordToPixel(place.x()),
                 rect.axis(QCPAxis::atLeft)->coordToPixel(place.y())},
                text);
    redraw();
}

void CrossMark::hide() {
    if (!m_mark.hide()) return;
    for (const QPointer<QCPItemTracer>& lines : m_lines) lines->setVisible(false);
    redraw();
}

void CrossMark::redraw() {
    redrawOverlay(m_plot);
}

void CrossMark::setStyle(const PlotStyle& style) {
    m_style = style;
    m_mark.setStyle(style);
    if (!m_lines.back()) return;
    QColor ground = style.background;
    ground.setAlpha(160);
    m_lines.front()->setPen(QPen(ground, 3));
    m_lines.back()->setPen(QPen(style.text, 1));
}

}  // namespace drillwave
