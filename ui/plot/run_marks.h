// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of pinned runs on a plot of a study.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointF>
#include <QVector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// A run as a point, in the units of the axes.
struct RunMark {
    int number = 0;  ///< of its letter and colour
    QString title;
    QPointF at;
    bool operator==(const RunMark&) const = default;
};

/// Points in the colours of their runs, named beside them, over everything else. A name goes around its
/// point to a free place, and is only its letters if there is no room for more. Lives as a child of the
/// plot.
class RunMarks : public QObject {
    Q_OBJECT

  public:
    RunMarks(QCustomPlot* plot, QCPAxis* x, QCPAxis* y);

    /// Replaces the marks; true if they differ, so that the plot needs a replot.
    bool present(const QVector<RunMark>& marks);
    void setStyle(const PlotStyle& style);
    const QVector<RunMark>& marks() const { return m_marks; }

  private:
    struct Drawn {
        RunMark mark;
        QString letters;
        QCPItemTracer* point;
        QCPItemText* name;
    };

    void draw();
    void placeNames();
    QVector<QRectF> taken() const;

    QCustomPlot* m_plot;
    QCPAxis* m_x;
    QCPAxis* m_y;
    PlotStyle m_style;
    QVector<RunMark> m_marks;
    QVector<Drawn> m_drawn;
};

}  // namespace drillwave
