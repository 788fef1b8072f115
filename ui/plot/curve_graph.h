// SPDX-License-Identifier: GPL-3.0-or-later
// Curves drawn as one line, of one thickness however many points they have.
#pragma once

#include <qcustomplot.h>

namespace drillwave {

/// Graph whose line is drawn on screen as one path, without the points that the screen cannot resolve.
/// QCPGraph draws a solid line segment by segment. Dense points then show as dots, and flat stretches look
/// thicker. Only very long lines (noisy records) are still drawn by segments, because this is faster.
class CurveGraph : public QCPGraph {
    Q_OBJECT

  public:
    using QCPGraph::QCPGraph;

  protected:
    void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& lines) const override;
};

/// Curve whose x may also decrease from point to point, drawn as one path like CurveGraph.
class CurvePath : public QCPCurve {
    Q_OBJECT

  public:
    using QCPCurve::QCPCurve;

  protected:
    void drawCurveLine(QCPPainter* painter, const QVector<QPointF>& lines) const override;
};

/// Adds a CurveGraph to the plot of these axes; call this instead of QCustomPlot::addGraph(). Returns the
/// graph, which the plot owns.
CurveGraph* addCurve(QCPAxis* keyAxis, QCPAxis* valueAxis);

/// Returns a line without the points that a screen cannot show; `pixel` is the size of a screen pixel in the
/// units of the points. Each half-pixel column keeps its first, lowest, highest and last point, in their
/// order. Straight stretches keep only their ends. A point that is not finite divides the line.
QVector<QPointF> thinnedLine(const QVector<QPointF>& line, double pixel);

}  // namespace drillwave
