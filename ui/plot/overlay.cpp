// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/overlay.h"

#include <qcustomplot.h>

namespace drillwave {

void redrawOverlay(QCustomPlot& plot) {
    QCPLayer& layer = *plot.layer(QStringLiteral("overlay"));
    // On paper it is drawn with all other layers, and before its first replot a plot has no buffer for
    // it.
    if (layer.mode() == QCPLayer::lmBuffered && plot.replotTime(true) > 0) layer.replot();
}

}  // namespace drillwave
