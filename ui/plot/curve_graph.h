// SPDX-License-Identifier: GPL-3.0-or-later
// Curves drawn as one line, of one thickness however many points they have.
#pragma once

#include <qcustomplot.h>

namespace drillwave {

/// QCPGraph draws a solid line on screen piece by piece, which is fast: where many points meet the pieces
/// cover each other, flat stretches come out thicker and each point is a dot. Here the line is one path
/// without points that the device cannot show apart, which is as fast and has the same dashes all along.
class CurveGraph : public QCPGraph {
    Q_OBJECT

  public:
    using QCPGraph::QCPGraph;

  protected:
    void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& lines) const override;
};

/// Draws curves that may turn back in the same way.
class CurvePath : public QCPCurve {
    Q_OBJECT

  public:
    using QCPCurve::QCPCurve;

  protected:
    void drawCurveLine(QCPPainter* painter, const QVector<QPointF>& lines) const override;
};

/// Adds a graph to the plot that owns the axes; instead of QCustomPlot::addGraph().
CurveGraph* addCurve(QCPAxis* keyAxis, QCPAxis* valueAxis);

/// Leaves out points that a device pixel of that size cannot show off the line through the others: of those
/// within one column the first, the extremes and the last stay, and of those in a row the ends. A point that
/// is not finite divides the line.
QVector<QPointF> thinnedLine(const QVector<QPointF>& line, double pixel);

}  // namespace drillwave
