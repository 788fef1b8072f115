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

/// Returns the name of a run in a legend: only its letter if there are more than three `runs`.
QString runLegend(const QString& title, qsizetype runs);

/// The pen of a run as a broad translucent band in dashes as long.
QPen runBand(QPen pen);

/// One run's curve.
template <class Data>
struct RunDrawing {
    int number = 0;  ///< of its letter, colour and dash
    QString title;   ///< "A  k 300 MN/m"
    Data data;
};
using RunCurve = RunDrawing<GraphData>;
/// A curve that may turn back.
using RunPath = RunDrawing<QSharedPointer<QCPCurveDataContainer>>;

/// Curves over two axes below those of the page, in the legend with their names or, if these do not fit or
/// are many, their letters. Lives as a child of the plot.
template <class Plottable, class Drawing>
class RunDrawings : public QObject {
  public:
    /// Relative width of runs beside many curves of the page.
    static constexpr double thin = 0.7;

    /// Without a legend the curves are neither read nor copied.
    RunDrawings(QCPAxis* x, QCPAxis* y, QCPLegend* legend, double width = 1)
        : QObject(x->parentPlot()),
          m_x(x),
          m_y(y),
          m_legend(legend),
          m_width(width),
          m_style(PlotStyle::forPaper()) {
        if (!legend) return;
        connect(x->parentPlot(), &QCustomPlot::beforeReplot, this, [this] { nameCurves(false); });
        connect(x->parentPlot(), &QCustomPlot::afterLayout, this, [this] { fitNames(); });
    }

    /// Translucent bands, where thin lines are curves of another kind; in the legend as the name of that
    /// which they are, with the letters of the runs: "N A".
    void setBands(const QString& name) { m_bands = name; }

    /// Replaces the curves. Curves of the same runs stay: hidden ones are still hidden, and one that is read
    /// is still read.
    void present(const QVector<Drawing>& drawings) {
        const bool isSame = std::ranges::equal(drawings, m_drawings, [](const auto& a, const auto& b) {
            return a.number == b.number && a.title == b.title;
        });
        m_drawings = drawings;
        if (!isSame) makeAnew();
        for (qsizetype i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setData(m_drawings[i].data);
    }
    /// Moves its entries after newer ones in the legend.
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
            if (m_legend) graph->removeFromLegend(m_legend);  // the plot does so only for its own
            plot.removePlottable(graph);
        }
        m_graphs.clear();
        for (qsizetype i = 0; i < m_drawings.size(); ++i) {
            Plottable* graph = add(m_x, m_y);
            graph->removeFromLegend();  // of the plot, which may have taken it in by itself
            graph->setLayer(ghostLayer(plot));
            graph->setSelectable(QCP::stNone);
            if constexpr (std::is_same_v<Plottable, QCPGraph>) graph->setAdaptiveSampling(false);
            if (m_legend) graph->addToLegend(m_legend);
            m_graphs.append(graph);
        }
        nameCurves(false);
        applyStyle();
    }
    void nameCurves(bool byLetters) {
        for (qsizetype i = 0; i < m_graphs.size(); ++i) {
            const QString& title = m_drawings[i].title;
            m_graphs[i]->setName(!m_bands.isEmpty() ? m_bands + QLatin1Char(' ') + title.left(1)
                                 : byLetters        ? title.left(1)
                                                    : runLegend(title, m_graphs.size()));
        }
    }
    // Shortens names, because a legend that is too wide for its row is squeezed and loses its last letters.
    void fitNames() {
        if (m_graphs.isEmpty() || !m_bands.isEmpty()) return;
        if (m_legend->minimumOuterSizeHint().width() <= m_legend->outerRect().width()) return;
        nameCurves(true);
        for (const auto phase :
             {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout})
            m_x->parentPlot()->plotLayout()->update(phase);
    }
    void applyStyle() {
        for (qsizetype i = 0; i < m_graphs.size(); ++i) {
            QPen pen = runPen(m_drawings[i].number, m_style);
            pen.setWidthF(m_width * pen.widthF());
            m_graphs[i]->setPen(m_bands.isEmpty() ? pen : runBand(pen));
        }
        if (m_legend) m_style.applyTo(*m_legend);
    }

    QCPAxis* m_x;
    QCPAxis* m_y;
    QCPLegend* m_legend;
    double m_width;
    QString m_bands;  // their name; empty where they are lines
    PlotStyle m_style;
    QVector<Drawing> m_drawings;
    QVector<Plottable*> m_graphs;
};

using RunGraphs = RunDrawings<QCPGraph, RunCurve>;
using RunPaths = RunDrawings<QCPCurve, RunPath>;

}  // namespace drillwave
