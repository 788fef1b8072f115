// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/here_mark.h"

#include "ui/plot/overlay.h"

namespace drillwave {

HereMark::HereMark(QCustomPlot* plot, QCPAxis* x, QCPAxis* y)
    : QObject(plot), m_line(new QCPItemStraightLine(plot)), m_ring(new QCPItemTracer(plot)) {
    for (QCPAbstractItem* item :
         {static_cast<QCPAbstractItem*>(m_line), static_cast<QCPAbstractItem*>(m_ring)}) {
        item->setLayer(QStringLiteral("overlay"));
        item->setSelectable(false);
        item->setVisible(false);
        item->setClipAxisRect(x->axisRect());
    }
    for (QCPItemPosition* position : {m_line->point1, m_line->point2}) {
        position->setAxes(x, y);
        position->setAxisRect(x->axisRect());
        position->setTypeX(QCPItemPosition::ptPlotCoords);
        position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    m_ring->position->setAxes(x, y);
    m_ring->position->setType(QCPItemPosition::ptPlotCoords);
    m_ring->setStyle(QCPItemTracer::tsCircle);
    m_ring->setSize(11);
}

void HereMark::setPlace(std::optional<double> x, std::optional<double> y) {
    if (x == m_x && y == m_y) return;
    m_x = x;
    m_y = y;
    m_line->setVisible(x.has_value());
    m_ring->setVisible(x && y);
    if (x) {
        m_line->point1->setCoords(*x, 0);
        m_line->point2->setCoords(*x, 1);
    }
    if (x && y) m_ring->position->setCoords(*x, *y);
    redrawOverlay(*m_line->parentPlot());
}

void HereMark::setStyle(const PlotStyle& style) {
    m_line->setPen(QPen(style.text, 1, Qt::DotLine));
    m_ring->setPen(QPen(style.text, 2));
    m_ring->setBrush(style.background);
}

}  // namespace drillwave
