// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/density_mark.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace drillwave {

DensityMark::DensityMark(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Density"));
    setToolTip(tr("Frequency of the values, from the smallest to the largest"));
}

void DensityMark::present(const Distribution& distribution) {
    m_distribution = distribution;
    update();
}

QSize DensityMark::sizeHint() const {
    const int line = fontMetrics().height();
    return {2 * line, line + 4};
}

// Between neighbouring quantiles lie equal shares: the density is the share over their distance.
void DensityMark::paintEvent(QPaintEvent*) {
    constexpr int parts = 48;
    constexpr double tail = 1e-3;
    const auto quantile = [&](int i) {
        return m_distribution.quantile(tail + (1 - 2 * tail) * i / double(parts));
    };
    const double least = quantile(0), most = quantile(parts);
    double largest = 0;
    QVector<QPointF> density;
    for (int i = 0; i < parts; ++i) {
        const double from = quantile(i), to = quantile(i + 1);
        if (!(to > from)) continue;
        const double height = 1 / (to - from);
        largest = std::max(largest, height);
        density << QPointF(from, height) << QPointF(to, height);
    }
    if (!(most > least) || !(largest > 0)) return;
    const QRectF area = QRectF(rect()).adjusted(1, 2, -1, -2);
    const auto place = [&](QPointF of) {
        return QPointF(area.left() + area.width() * (of.x() - least) / (most - least),
                       area.bottom() - area.height() * of.y() / largest);
    };
    QPainterPath path(place({least, 0}));
    for (const QPointF& point : density) path.lineTo(place(point));
    path.lineTo(place({most, 0}));
    path.closeSubpath();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor colour = palette().color(QPalette::Highlight);
    painter.setPen(QPen(colour, 1));
    colour.setAlphaF(0.35F);
    painter.fillPath(path, colour);
    painter.drawPath(path);
}

}  // namespace drillwave
