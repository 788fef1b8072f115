// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a blow sequence: gaps and penetrations, distribution and succession of the gaps, and the
// energy.
#pragma once

#include <qcustomplot.h>

#include <optional>

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/run_marks.h"

namespace drillwave {

/// Axis rects and curves of a blow sequence. The parent frame owns them; it fits the plot and places gaps(),
/// penetrations() and details() in the layout.
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
    /// Shows the mean penetrations of pinned runs (results kept for comparison) at the right end of the
    /// penetrations.
    void presentRuns(const QVector<RunMark>& means);
    const QVector<RunMark>& runMarks() const { return m_runs->marks(); }
    /// Returns the number of the blow (from 1) at x in `rect`. Nothing if `rect` is not a plot over blows, or
    /// has no such blow.
    std::optional<long> blowAt(const QCPAxisRect* rect, double x) const;
    void setStyle(const PlotStyle& style);
    void fit();

  private:
    /// Plot of one quantity of every blow.
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
