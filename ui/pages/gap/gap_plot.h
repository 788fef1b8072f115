// SPDX-License-Identifier: GPL-3.0-or-later
// An output over one period of the gap, and its distribution beside it on the same axis (paper, Fig. 8).
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

#include "ui/pages/gap/gap_picture.h"
#include "ui/pages/run_graphs.h"
#include "ui/pages/study/run_marks.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/here_mark.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Draws the picture of a study of the gap, on screen and in files alike. Lives as a child of the plot.
class GapPlot : public QObject {
    Q_OBJECT

  public:
    explicit GapPlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted, or output or units changed.
    void present(const GapPicture& picture);
    /// No curve, and `message` in its place (why there is none).
    void showNothing(const QString& message);
    /// Where the present scenario is, in shown units.
    void setHere(const std::optional<QPointF>& place);
    /// The same output of pinned runs, over the gaps of the picture, and where the runs are.
    void setRuns(const QVector<RunCurve>& curves, const QVector<RunMark>& marks);
    void setStyle(const PlotStyle& style);
    /// The whole period in view.
    void fit();
    QCPGraph* graph() const { return m_graph; }
    const RunGraphs& runs() const { return *m_runs; }
    /// Whether a point of the plot is beside the curve, on the distribution.
    bool isDistribution(const QCPAxisRect* rect) const { return rect == m_beside; }
    /// Where keys may go: along the curves over the gap, to the marks.
    KeyPlaces keyPlaces() const;
    /// What the plot shows, in words, for assistive tools and the line above it.
    QString textSummary() const { return m_summary; }

  private:
    void addRects();
    void addLegend();
    void linkAxes();
    void addLines();
    void placeBands();
    void breakCaption();
    void showSpread();
    void setFramesVisible(bool visible);
    QString summary() const;

    QCustomPlot* m_plot;
    QCPAxisRect* m_rect = nullptr;    // value over gap
    QCPAxisRect* m_beside = nullptr;  // shares of gaps over value
    QCPLegend* m_legend = nullptr;
    QCPTextElement* m_caption = nullptr;
    QCPGraph* m_graph = nullptr;
    QCPCurve* m_shares = nullptr;
    QCPCurve* m_below = nullptr;
    QCPItemRect* m_bands[2] = {};  // super rebound, in both rects
    QCPItemText* m_bandName = nullptr;
    QCPItemStraightLine* m_lines[2][3] = {};  // 5 %, mean, 95 %, in both rects
    QCPItemText* m_lineNames[3] = {};
    CurveMarks* m_marks = nullptr;
    HereMark* m_here = nullptr;
    RunGraphs* m_runs = nullptr;
    RunMarks* m_runMarks = nullptr;
    PlotMessage* m_message;
    GapPicture m_picture;
    PlotStyle m_style;
    FittedView* m_view;
    QString m_summary;
};

}  // namespace drillwave
