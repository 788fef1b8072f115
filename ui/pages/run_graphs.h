// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of pinned runs in a plot.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <QVector>

#include "ui/plot/graph_data.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// One run's curve.
struct RunCurve {
    int number = 0;  ///< of its letter, colour and dash
    QString title;   ///< "A  k 300 MN/m"
    GraphData data;
};

/// Graphs over two axes behind the curves of the page, in the legend with their letters or, where they are
/// few, their names. Lives as a child of the plot.
class RunGraphs : public QObject {
    Q_OBJECT

  public:
    /// Without a legend the curves are neither read nor copied.
    RunGraphs(QCPAxis* x, QCPAxis* y, QCPLegend* legend);

    /// These in place of the last ones.
    void present(const QVector<RunCurve>& curves);
    void setStyle(const PlotStyle& style);
    const QVector<QCPGraph*>& graphs() const { return m_graphs; }

  private:
    void applyStyle();

    QCPAxis* m_x;
    QCPAxis* m_y;
    QCPLegend* m_legend;
    PlotStyle m_style;
    QVector<RunCurve> m_curves;
    QVector<QCPGraph*> m_graphs;
};

/// How a legend calls a run beside others: by its name where there is room for it.
QString runLegend(const QString& title, qsizetype runs);

}  // namespace drillwave
