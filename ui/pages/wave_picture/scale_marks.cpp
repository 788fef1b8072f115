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
    // To the middle of the lines around it.
    const QRectF bar = QRectF(m_bar->axis()->axisRect()->rect()).translated(0, -1);
    const double unit = picture().units.of(picture().raster.quantity).factor;
    const auto markValue = [&](float value, bool clipped) {
        if (clipped || value == 0) return;
        const double y = m_bar->axis()->coordToPixel(double(value) * unit);
        for (const auto& [colour, width] :
             {std::pair(m_style.background, 4.0), std::pair(m_style.text, 2.0)}) {
            painter->setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
            painter->drawLine(QLineF(bar.left(), y, bar.right(), y));
        }
    };
    const auto markEnd = [&](double y, double tip, bool clipped) {
        if (!clipped) return;
        painter->setPen(Qt::NoPen);
        painter->setBrush(m_style.text);
        painter->drawPolygon(QPolygonF({{bar.left(), y}, {bar.right(), y}, {bar.center().x(), tip}}));
    };
    painter->setAntialiasing(true);
    markValue(picture().least, isClippedBelow(picture()));
    markValue(picture().largest, isClippedAbove(picture()));
    markEnd(bar.bottom(), bar.bottom() + headHeight, isClippedBelow(picture()));
    markEnd(bar.top(), bar.top() - headHeight, isClippedAbove(picture()));
}

}  // namespace drillwave
