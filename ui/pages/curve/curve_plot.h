// SPDX-License-Identifier: GPL-3.0-or-later
// An output along a parameter, a curve for each value of a family (paper, Fig. 6).
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <memory>
#include <optional>

#include "ui/pages/curve/curve_picture.h"
#include "ui/pages/curve/preset_bands.h"
#include "ui/pages/run_graphs.h"
#include "ui/pages/study/run_marks.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/here_mark.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Draws the picture of a study along a parameter, on screen and in files alike. Lives as a child of the
/// plot.
class CurvePlot : public QObject {
    Q_OBJECT

  public:
    explicit CurvePlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted, or axes or units changed.
    void present(const CurvePicture& picture);
    /// No curves, and `message` in their place (why there are none).
    void showNothing(const QString& message);
    /// Where the present scenario is, in shown units.
    void setHere(std::optional<double> x, std::optional<double> y);
    /// The same output of pinned runs over the range of the picture, and where they are, in shown units.
    void setRuns(const QVector<RunCurve>& curves, const QVector<RunMark>& marks);
    const RunGraphs& runCurves() const { return *m_runCurves; }
    const QVector<RunMark>& runs() const { return m_runs->marks(); }
    void setStyle(const PlotStyle& style);
    /// The whole range in view.
    void fit();

    const CurvePicture& picture() const { return m_picture; }
    /// In the order of CurvePicture::lines.
    const QVector<QCPGraph*>& graphs() const { return m_graphs; }

    /// What a click means: the nearest place worth it within some pixels of it, a mark or a curve.
    struct Target {
        double x = 0;   ///< as shown
        int line = -1;  ///< of the picture; -1 away from all of them
        bool isMark = false;
    };
    Target targetAt(QPointF coordinates) const;
    /// Where keys may go: along the curves, to marks and extremes.
    KeyPlaces keyPlaces() const;

  private:
    void addRect();
    void makeGraphs();
    void showAxes();
    void dropMarks();

    QCustomPlot* m_plot;
    QCPAxisRect* m_rect = nullptr;
    QCPLegend* m_legend = nullptr;
    QVector<QCPGraph*> m_graphs;
    QCPGraph* m_extremes = nullptr;
    QCPItemStraightLine* m_one = nullptr;
    PresetBands* m_bands = nullptr;
    std::unique_ptr<CurveMarks> m_marks;
    HereMark* m_here = nullptr;
    RunGraphs* m_runCurves = nullptr;
    RunMarks* m_runs = nullptr;
    PlotMessage* m_message;
    CurvePicture m_picture;
    PlotStyle m_style;
    FittedView* m_view;
};

}  // namespace drillwave
