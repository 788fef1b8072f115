// SPDX-License-Identifier: GPL-3.0-or-later
// Curves cut at the edges of their axes, for formats that do not clip.
#pragma once

#include <qcustomplot.h>

#include <QSharedPointer>
#include <QVector>

namespace drillwave {

/// The parts of the line through `points` that are within both ranges, cut where it crosses them, with a
/// point of NaN wherever it was outside in between. A range on a logarithmic scale must be positive.
QVector<QCPGraphData> clippedLine(const QCPGraphDataContainer& points, const QCPAxis& keyAxis,
                                  const QCPAxis& valueAxis);

/// While it lives, all graphs of the plot that leave their axes are cut there.
class CurveClip {
  public:
    explicit CurveClip(QCustomPlot& plot);
    ~CurveClip();
    CurveClip(const CurveClip&) = delete;
    CurveClip& operator=(const CurveClip&) = delete;

  private:
    struct Whole {
        QCPGraph* graph;
        QSharedPointer<QCPGraphDataContainer> data;
    };
    QVector<Whole> m_whole;
};

}  // namespace drillwave
