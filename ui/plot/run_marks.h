// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of pinned runs (results kept for comparison) on the plot of a study.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointF>
#include <QVector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Pinned run (a result kept for comparison) shown as a point, with x and y in the units of the axes.
struct RunMark {
    int number = 0;  ///< number of the run (from 0), which decides its letter and colour
    QString title;
    QPointF at;
    bool operator==(const RunMark&) const = default;
};

/// Marks of pinned runs (results kept for comparison) as squares in the colours of the runs, above everything
/// else. Each has its name beside it where there is space, otherwise only the letter of the run. The plot
/// owns the object.
class RunMarks : public QObject {
    Q_OBJECT

  public:
    RunMarks(QCustomPlot* plot, QCPAxis* x, QCPAxis* y);

    /// Replaces the marks of the pinned runs. Returns true if they differ from the present ones; the plot
    /// must then be redrawn.
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
