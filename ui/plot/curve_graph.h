// SPDX-License-Identifier: GPL-3.0-or-later
// Curves drawn as one line, of one thickness however many points they have.
#pragma once

#include <qcustomplot.h>

namespace drillwave {

/// Graph whose solid line is drawn on screen as one path, without the points that the device cannot resolve.
/// QCPGraph draws such a line segment by segment, so that dense points show as dots and flat stretches look
/// thicker. One path is as fast, and its dashes are regular.
class CurveGraph : public QCPGraph {
    Q_OBJECT

  public:
    using QCPGraph::QCPGraph;

  protected:
    void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& lines) const override;
};

/// Curve that may turn back in x, drawn as one path like CurveGraph.
class CurvePath : public QCPCurve {
    Q_OBJECT

  public:
    using QCPCurve::QCPCurve;

  protected:
    void drawCurveLine(QCPPainter* painter, const QVector<QPointF>& lines) const override;
};

/// Adds a CurveGraph to the plot of the axes, instead of QCustomPlot::addGraph(). Returns the graph, which
/// the plot owns.
CurveGraph* addCurve(QCPAxis* keyAxis, QCPAxis* valueAxis);

/// Returns a line without the points that a display with pixels of size `pixel` cannot show. Each half-pixel
/// column keeps its first, lowest, highest and last point, in their order. Straight stretches keep only their
/// ends. A point that is not finite divides the line.
QVector<QPointF> thinnedLine(const QVector<QPointF>& line, double pixel);

}  // namespace drillwave
