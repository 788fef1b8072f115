// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of pinned runs in a plot.
#pragma once

#include <qcustomplot.h>

#include <QString>
#include <QVector>
#include <algorithm>
#include <type_traits>
#include <utility>

#include "ui/plot/curve_graph.h"
#include "ui/plot/graph_data.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/run_pen.h"

namespace drillwave {

/// How a legend calls a run beside others: by its name where there is room for it.
QString runLegend(const QString& title, qsizetype runs);

/// One run's curve.
template <class Data>
struct RunDrawing {
    int number = 0;  ///< of its letter, colour and dash
    QString title;   ///< "A  k 300 MN/m"
    Data data;
};
using RunCurve = RunDrawing<GraphData>;
/// One that may turn back.
using RunPath = RunDrawing<QSharedPointer<QCPCurveDataContainer>>;

/// Curves over two axes behind those of the page, in the legend with their letters or, where they are few,
/// their names. Lives as a child of the plot.
template <class Plottable, class Drawing>
class RunDrawings : public QObject {
  public:
    /// Over the width of other lines: beside many curves of the page those of runs stand back.
    static constexpr double thin = 0.7;

    /// Without a legend the curves are neither read nor copied.
    RunDrawings(QCPAxis* x, QCPAxis* y, QCPLegend* legend, double width = 1)
        : QObject(x->parentPlot()),
          m_x(x),
          m_y(y),
          m_legend(legend),
          m_width(width),
          m_style(PlotStyle::forPaper()) {}

    /// These in place of the last ones. Curves of the same runs stay: hidden ones are hidden, and what is
    /// read goes on being read.
    void present(const QVector<Drawing>& drawings) {
        const bool isSame = std::ranges::equal(drawings, m_drawings, [](const auto& a, const auto& b) {
            return a.number == b.number && a.title == b.title;
        });
        m_drawings = drawings;
        if (!isSame) makeAnew();
        for (qsizetype i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setData(m_drawings[i].data);
    }
    /// Behind what has come into the legend since.
    void standLast() {
        if (!m_legend) return;
        for (Plottable* graph : std::as_const(m_graphs)) {
            graph->removeFromLegend(m_legend);
            graph->addToLegend(m_legend);
        }
        m_style.applyTo(*m_legend);
    }
    void setStyle(const PlotStyle& style) {
        m_style = style;
        applyStyle();
    }
    const QVector<Plottable*>& graphs() const { return m_graphs; }

  private:
    static Plottable* add(QCPAxis* x, QCPAxis* y) {
        if constexpr (std::is_same_v<Plottable, QCPGraph>)
            return addCurve(x, y);
        else
            return new CurvePath(x, y);
    }
    void makeAnew() {
        QCustomPlot& plot = *m_x->parentPlot();
        for (Plottable* graph : std::as_const(m_graphs)) {
            if (m_legend) graph->removeFromLegend(m_legend);  // the plot would do so from its own alone
            plot.removePlottable(graph);
        }
        m_graphs.clear();
        for (const Drawing& drawing : m_drawings) {
            Plottable* graph = add(m_x, m_y);
            graph->removeFromLegend();  // of the plot, which may have taken it in by itself
            graph->setLayer(ghostLayer(plot));
            graph->setSelectable(QCP::stNone);
            graph->setName(runLegend(drawing.title, m_drawings.size()));
            if constexpr (std::is_same_v<Plottable, QCPGraph>) graph->setAdaptiveSampling(false);
            if (m_legend) graph->addToLegend(m_legend);
            m_graphs.append(graph);
        }
        applyStyle();
    }
    void applyStyle() {
        for (qsizetype i = 0; i < m_graphs.size(); ++i) {
            QPen pen = runPen(m_drawings[i].number, m_style);
            pen.setWidthF(m_width * pen.widthF());
            m_graphs[i]->setPen(pen);
        }
        if (m_legend) m_style.applyTo(*m_legend);
    }

    QCPAxis* m_x;
    QCPAxis* m_y;
    QCPLegend* m_legend;
    double m_width;
    PlotStyle m_style;
    QVector<Drawing> m_drawings;
    QVector<Plottable*> m_graphs;
};

using RunGraphs = RunDrawings<QCPGraph, RunCurve>;
using RunPaths = RunDrawings<QCPCurve, RunPath>;

}  // namespace drillwave
