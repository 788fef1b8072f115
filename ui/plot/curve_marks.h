// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of a curve with their numbers: target values, extremes, crossings and kinks.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointF>
#include <QVector>

#include "core/report/figure.h"
#include "ui/plot/plot_style.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Point of a curve that gets a mark and a label, such as a maximum or a kink.
struct CurveMark {
    using Kind = MarkKind;
    Kind kind = Kind::kink;
    QPointF at;  ///< x and y in the units of the axes
    bool operator==(const CurveMark&) const = default;
};

/// Marks on a graph, each with a label that avoids the curves on the same axes and other labels. Marks of a
/// kind (kinks, extremes, crossings) have no labels if there are too many of them. The plot owns the object.
class CurveMarks : public QObject {
    Q_OBJECT

  public:
    explicit CurveMarks(QCPGraph* graph);

    /// Replaces the marks and labels. The labels show x and y of their points in the units `x` and `y`, which
    /// are those of the axes.
    void present(const QVector<CurveMark>& marks, const ShownUnit& x, const ShownUnit& y);
    /// Removes all marks of the curve, and their labels.
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
