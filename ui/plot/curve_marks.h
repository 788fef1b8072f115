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

/// Point of a curve that gets a mark and a label.
struct CurveMark {
    using Kind = MarkKind;
    Kind kind = Kind::kink;
    QPointF at;  ///< x and y in the units of the axes
    bool operator==(const CurveMark&) const = default;
};

/// Marks on a graph, each with a label that avoids the curves of the axes and other labels. If a kind has too
/// many marks, they are shown without labels. The plot owns the object.
class CurveMarks : public QObject {
    Q_OBJECT

  public:
    explicit CurveMarks(QCPGraph* graph);

    /// Replaces the marks and labels. `x` and `y` are the units of the axes, which the labels show.
    void present(const QVector<CurveMark>& marks, const ShownUnit& x, const ShownUnit& y);
    /// Removes all marks and labels.
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
