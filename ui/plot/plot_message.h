// SPDX-License-Identifier: GPL-3.0-or-later
// Why a plot shows nothing, in words on a plate that stays within the plot.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Hidden without a text. Long sentences are broken to the width of the plot.
class PlotMessage : public QObject {
    Q_OBJECT

  public:
    explicit PlotMessage(QCustomPlot* plot);

    void show(const QString& text);
    void hide() { m_item->setVisible(false); }
    void setStyle(const PlotStyle& style);
    /// The item with its line breaks; for tests.
    const QCPItemText& item() const { return *m_item; }

  private:
    void breakLines();

    QCustomPlot* m_plot;
    QCPItemText* m_item;
    QString m_text;
};

}  // namespace drillwave
