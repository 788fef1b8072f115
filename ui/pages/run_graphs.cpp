// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/run_graphs.h"

#include "ui/plot/curve_graph.h"
#include "ui/plot/run_pen.h"

namespace drillwave {

RunGraphs::RunGraphs(QCPAxis* x, QCPAxis* y, QCPLegend* legend)
    : QObject(x->parentPlot()), m_x(x), m_y(y), m_legend(legend), m_style(PlotStyle::forPaper()) {}

void RunGraphs::present(const QVector<RunCurve>& curves) {
    QCustomPlot& plot = *m_x->parentPlot();
    for (QCPGraph* graph : std::as_const(m_graphs)) {
        if (m_legend) graph->removeFromLegend(m_legend);  // the plot would do so from its own alone
        plot.removeGraph(graph);
    }
    m_graphs.clear();
    m_curves = curves;
    for (const RunCurve& curve : curves) {
        QCPGraph* graph = addCurve(m_x, m_y);
        graph->setLayer(ghostLayer(plot));
        graph->setSelectable(QCP::stNone);
        graph->setAdaptiveSampling(false);
        graph->setName(runLegend(curve.title, curves.size()));
        graph->setData(curve.data);
        if (m_legend) graph->addToLegend(m_legend);
        m_graphs.append(graph);
    }
    applyStyle();
}

void RunGraphs::setStyle(const PlotStyle& style) {
    m_style = style;
    applyStyle();
}

void RunGraphs::applyStyle() {
    for (qsizetype i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setPen(runPen(m_curves[i].number, m_style));
    if (m_legend) m_style.applyTo(*m_legend);
}

QString runLegend(const QString& title, qsizetype runs) {
    constexpr qsizetype few = 3;
    constexpr qsizetype mostLetters = 24;
    if (runs > few) return title.left(1);
    return title.size() > mostLetters ? title.left(mostLetters - 1) + QStringLiteral("…") : title;
}

}  // namespace drillwave
