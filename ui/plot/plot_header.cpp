// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_header.h"

#include <qcustomplot.h>

namespace drillwave {

QCPTextElement* addPlotHeader(QCustomPlot& plot, int spaceBelow) {
    auto* header = new QCPLayoutGrid;
    header->setRowSpacing(0);
    plot.plotLayout()->insertRow(0);
    plot.plotLayout()->addElement(0, 0, header);
    plot.plotLayout()->setRowStretchFactor(0, 1e-3);  // as high as it has to be
    plot.legend->setVisible(true);
    plot.legend->setMargins(QMargins(7, 6, 0, 0));
    auto* caption = new QCPTextElement(&plot);
    caption->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    caption->setMargins(QMargins(7, 0, 0, spaceBelow));
    header->addElement(0, 0, plot.legend);
    header->addElement(1, 0, caption);
    return caption;
}

}  // namespace drillwave
