// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of pinned runs (results kept for comparison) in a plot.
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

/// Returns the legend text of the pinned run with this title, at most 24 characters long. If there are more
/// than three runs (`runs` is their number), it is only the letter of the run.
QString runLegend(const QString& title, qsizetype runs);

/// Returns the pen for showing a run as a band: `pen` made translucent and 4 px wide, with the same dashes.
QPen runBand(QPen pen);

/// Curve of one pinned run (a result kept for comparison), with its points in `data`.
template <class Data>
struct RunDrawing {
    int number = 0;  ///< number of the run (from 0), which decides its letter, colour and dash pattern
    QString title;   ///< title of the run: its letter and what differs, such as "A  k 300 MN/m"
    Data data;
};
/// Curve of a pinned run (a result kept for comparison) whose x never decreases.
using RunCurve = RunDrawing<GraphData>;
/// Curve of a pinned run (a result kept for comparison) whose x may also decrease along the curve, such as a
/// force–penetration loop.
using RunPath = RunDrawing<QSharedPointer<QCPCurveDataContainer>>;

/// Curves of pinned runs (results kept for comparison) on one pair of axes, drawn below the curves of the
/// page. The legend gives their names, or only their letters if the names do not fit or are many. The plot
/// owns the object.
template <class Plottable, class Drawing>
class RunDrawings : public QObject {
  public:
    /// Factor of the line width of pinned runs (results kept for comparison) in plots that have many curves
    /// of their own.
    static constexpr double thin = 0.7;

    /// Creates an empty set of curves on the axes `x` and `y`. If `legend` is nullptr, the user can neither
    /// read nor copy the curves. `width` is a factor of the line width.
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

    /// Draws the runs as translucent bands, because thin lines already have another meaning in this plot.
    /// `name` is the name of the quantity; the legend shows it with the letter of the run, such as "N A".
    void setBands(const QString& name) { m_bands = name; }

    /// Replaces the curves of the pinned runs. If the runs are the same as before, curves hidden by the user
    /// stay hidden, and the curve chosen for the readings stays chosen.
    void present(const QVector<Drawing>& drawings) {
        const bool isSame = std::ranges::equal(drawings, m_drawings, [](const auto& a, const auto& b) {
            return a.number == b.number && a.title == b.title;
        });
        m_drawings = drawings;
        if (!isSame) makeAnew();
        for (qsizetype i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setData(m_drawings[i].data);
    }
    /// Moves the legend entries of the pinned runs to the end of the legend.
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
            if (m_legend) graph->removeFromLegend(m_legend);  // the plot removes it only from its own legend
            plot.removePlottable(graph);
        }
        m_graphs.clear();
        for (qsizetype i = 0; i < m_drawings.size(); ++i) {
            Plottable* graph = add(m_x, m_y);
            graph->removeFromLegend();  // the plot may have added it to its own legend
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
    QString m_bands;  // name of the bands; empty if the runs are lines
    PlotStyle m_style;
    QVector<Drawing> m_drawings;
    QVector<Plottable*> m_graphs;
};

using RunGraphs = RunDrawings<QCPGraph, RunCurve>;
using RunPaths = RunDrawings<QCPCurve, RunPath>;

}  // namespace drillwave
