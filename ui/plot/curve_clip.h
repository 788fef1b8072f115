// SPDX-License-Identifier: GPL-3.0-or-later
// Curves cut at the edges of their axes, for formats that do not clip.
#pragma once

#include <qcustomplot.h>

#include <QSharedPointer>
#include <QVector>

namespace drillwave {

/// Returns the parts of the line through `points` that are within both axis ranges. The line is cut where it
/// crosses a range; a point with value NaN separates parts. The range of a logarithmic axis must be positive.
QVector<QCPGraphData> clippedLine(const QCPGraphDataContainer& points, const QCPAxis& keyAxis,
                                  const QCPAxis& valueAxis);

/// Guard that clips all graphs of a plot at the edges of their axes during its lifetime. The destructor
/// restores their data.
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
