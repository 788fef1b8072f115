// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/scale_marks.h"

namespace drillwave {
namespace {

constexpr double headHeight = 8;  // [px]

}  // namespace

ScaleMarksItem::ScaleMarksItem(QCustomPlot* plot, const QCPColorScale* bar)
    : WavePictureItem(plot), m_bar(bar) {
    setClipToAxisRect(false);
}

void ScaleMarksItem::draw(QCPPainter* painter) {
    if (!m_blow) return;
    const QRectF bar(m_bar->axis()->axisRect()->rect());
    const double unit = picture().units.of(picture().raster.quantity).factor;
    const auto markValue = [&](float value, bool clipped) {
        if (clipped || value == 0) return;
        const double y = m_bar->axis()->coordToPixel(double(value) * unit);
        painter->setPen(QPen(m_style.background, 4));
        painter->drawLine(QLineF(bar.left(), y, bar.right() + 1, y));
        painter->setPen(QPen(m_style.text, 2));
        painter->drawLine(QLineF(bar.left(), y, bar.right() + 1, y));
    };
    const auto markEnd = [&](double y, double tip, bool clipped) {
        if (!clipped) return;
        painter->setPen(Qt::NoPen);
        painter->setBrush(m_style.text);
        painter->drawPolygon(
            QPolygonF({{bar.left(), y}, {bar.right() + 1, y}, {bar.center().x() + 0.5, tip}}));
    };
    painter->setAntialiasing(true);
    markValue(picture().least, isClippedBelow(picture()));
    markValue(picture().largest, isClippedAbove(picture()));
    markEnd(bar.bottom() + 2, bar.bottom() + 2 + headHeight, isClippedBelow(picture()));
    markEnd(bar.top() - 1, bar.top() - 1 - headHeight, isClippedAbove(picture()));
}

}  // namespace drillwave
