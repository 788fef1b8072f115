// SPDX-License-Identifier: GPL-3.0-or-later
// Goals, extremes, crossings and kinks of a curve, with their numbers.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointF>
#include <QVector>

#include "core/report/figure.h"
#include "ui/plot/plot_style.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// A place of a curve that is named.
struct CurveMark {
    using Kind = MarkKind;
    Kind kind = Kind::kink;
    QPointF at;  ///< parameter and value as shown
    bool operator==(const CurveMark&) const = default;
};

/// Points of a graph with words beside them that keep clear of the curves of its axes and of each other.
/// If there are too many of a kind to be read, they are marked without numbers. Lives as a child of the
/// plot.
class CurveMarks : public QObject {
    Q_OBJECT

  public:
    explicit CurveMarks(QCPGraph* graph);

    /// Replaces the marks, in the units of the axes.
    void present(const QVector<CurveMark>& marks, const ShownUnit& x, const ShownUnit& y);
    void clear();
    const QCPGraph* graph() const { return m_graph; }
    void setStyle(const PlotStyle& style);

  private:
    void add(const CurveMark& mark, const QString& words);
    void applyStyle();
    QVector<QRectF> ownPointsBut(QPointF named) const;
    void placeWords();

    QCPGraph* m_graph;
    PlotStyle m_style;
    QVector<QCPItemTracer*> m_points;
    QVector<QCPItemText*> m_words;
};

}  // namespace drillwave
