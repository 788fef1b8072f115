// SPDX-License-Identifier: GPL-3.0-or-later
// Axis rects of a sequence of blows: gap and penetration blow by blow; distribution of the gaps, next gap
// over gap, and energy in a row of details.
#pragma once

#include <qcustomplot.h>

#include <optional>

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/run_marks.h"

namespace drillwave {

/// Lives as a child of the frame that fits the plot and places gaps(), penetrations() and details().
class MarchRects : public QObject {
    Q_OBJECT

  public:
    MarchRects(QCustomPlot& plot, QObject* parent);

    QCPLayoutGrid* details() const { return m_details; }
    QCPAxisRect* gaps() const { return m_gaps.rect; }
    QCPAxisRect* penetrations() const { return m_penetrations.rect; }
    QCPGraph* gapPoints() const { return m_gaps.now; }
    QCPGraph* penetrationPoints() const { return m_penetrations.now; }
    QCPGraph* gapsBefore() const { return m_gaps.before; }
    QCPBars* parts() const { return m_parts; }
    QCPGraph* cor() const { return m_cor; }
    QCPCurve* returns() const { return m_returns; }
    QCPBars* energy() const { return m_energy; }

    void present(const MarchPicture& picture, const BlowPoints& before, const DrillingShown& units);
    /// Mean penetrations of pinned runs, at the end of the blows.
    void presentRuns(const QVector<RunMark>& means);
    const QVector<RunMark>& runMarks() const { return m_runs->marks(); }
    /// The number of the blow at that place, where the rect is one of blows and has it.
    std::optional<long> blowAt(const QCPAxisRect* rect, double x) const;
    void setStyle(const PlotStyle& style);
    void fit();

  private:
    /// A number of every blow.
    struct Series {
        QCPAxisRect* rect;
        QCPGraph *now, *before;
        QCPItemRect* settled;
    };
    Series addSeries();
    void addDetails();
    QCPGraph* addPoints(QCPAxisRect* rect);
    void showSettled(const Series& series, const MarchPicture& picture);
    void showEnergy(const MarchPicture& picture);
    void fitSeries(const Series& series);

    QCustomPlot& m_plot;
    QCPLayoutGrid* m_details;
    Series m_gaps, m_penetrations;
    QCPAxisRect *m_partsRect, *m_returnRect, *m_energyRect;
    QCPBars *m_parts, *m_energy;
    QCPGraph *m_cor, *m_returnPoints;
    QCPCurve* m_returns;
    QVector<QCPItemText*> m_shares;
    RunMarks* m_runs;
    double m_blows = 1;
};

}  // namespace drillwave
