// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes, crossings of 1 and kinks of the curve over the gap, with their numbers.
#pragma once

#include <qcustomplot.h>

#include <QObject>

#include "ui/pages/gap/gap_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Points of a graph with words beside them that keep clear of the curve and of each other, or are left out
/// where there is no room. Lives as a child of the plot.
class GapMarks : public QObject {
    Q_OBJECT

  public:
    explicit GapMarks(QCPGraph* graph);

    /// Those of the picture in place of the last ones.
    void present(const GapPicture& picture);
    void clear();
    void setStyle(const PlotStyle& style);

  private:
    void add(const GapMark& mark, const QString& words);
    void applyStyle();
    void placeWords();

    QCPGraph* m_graph;
    PlotStyle m_style;
    QVector<QCPItemTracer*> m_points;
    QVector<QCPItemText*> m_words;
};

}  // namespace drillwave
