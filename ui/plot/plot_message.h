// SPDX-License-Identifier: GPL-3.0-or-later
// A message in a box on a plot, which says why the plot shows nothing.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Message in a box on a plot; hidden at first. Long sentences are broken at 80 % of the plot's width.
class PlotMessage : public QObject {
    Q_OBJECT

  public:
    explicit PlotMessage(QCustomPlot* plot);

    void show(const QString& text);
    void hide() { m_item->setVisible(false); }
    void setStyle(const PlotStyle& style);
    /// Returns the text item with its line breaks; for tests.
    const QCPItemText& item() const { return *m_item; }

  private:
    void breakLines();

    QCustomPlot* m_plot;
    QCPItemText* m_item;
    QString m_text;
};

}  // namespace drillwave
