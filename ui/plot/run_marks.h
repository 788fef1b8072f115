// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of pinned runs (results kept for comparison) on the plot of a study.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointF>
#include <QVector>

#include "ui/plot/plot_style.h"

namespace drillwave {

/// Pinned run shown as a point, with x and y in the units of the axes.
struct RunMark {
    int number = 0;  ///< number of the run (from 0), which decides its letter and colour
    QString title;
    QPointF at;
    bool operator==(const RunMark&) const = default;
};

/// Marks of pinned runs in their colours, each with its name, above everything else. A name is placed around
/// its point where there is space, and shortened to the letter of the run otherwise. The plot owns the
/// object.
class RunMarks : public QObject {
    Q_OBJECT

  public:
    RunMarks(QCustomPlot* plot, QCPAxis* x, QCPAxis* y);

    /// Replaces the marks. Returns whether they differ from the present ones, so that the plot must be
    /// redrawn.
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
