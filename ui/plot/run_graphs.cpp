// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/run_graphs.h"

namespace drillwave {

QPen runBand(QPen pen) {
    QColor color = pen.color();
    color.setAlpha(110);
    pen.setColor(color);
    pen.setWidthF(4);
    // Dashes are counted in widths.
    QList<qreal> dashes = pen.dashPattern();
    for (qreal& dash : dashes) dash = std::max(0.8, dash / 2);
    pen.setDashPattern(dashes);
    return pen;
}

QString runLegend(const QString& title, qsizetype runs) {
    constexpr qsizetype few = 3;
    constexpr qsizetype mostLetters = 24;
    if (runs > few) return title.left(1);
    return title.size() > mostLetters ? title.left(mostLetters - 1) + QStringLiteral("…") : title;
}

}  // namespace drillwave
