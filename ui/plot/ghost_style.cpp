// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/ghost_style.h"

#include <qcustomplot.h>

namespace drillwave {

QPen ghostPen(const PlotStyle& style, int index) {
    QColor color = style.lines[index % PlotStyle::lineKinds];
    color.setAlpha(170);
    QPen pen(color, 1);
    pen.setDashPattern({3, 2});
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

QCPLayer* ghostLayer(QCustomPlot& plot) {
    const QString name = QStringLiteral("ghost");
    if (!plot.layer(name)) plot.addLayer(name, plot.layer(QStringLiteral("main")), QCustomPlot::limBelow);
    return plot.layer(name);
}

}  // namespace drillwave
