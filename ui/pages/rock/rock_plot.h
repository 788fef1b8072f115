// SPDX-License-Identifier: GPL-3.0-or-later
// Impact force against penetration: the enclosed area is the energy left in the rock (paper, Fig. 1).
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <QString>
#include <optional>

#include "ui/pages/rock/rock_curve.h"
#include "ui/pages/run_graphs.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Draws the path of a blow with its area, slopes and extremes named, on screen and in files alike. Lives as
/// a child of the plot.
class RockPlot : public QObject {
    Q_OBJECT

  public:
    explicit RockPlot(QCustomPlot* plot);

    /// Shows the curve; the view stays where it is unless it was fitted or the units changed.
    void present(const RockCurve& curve);
    /// No curve, and `message` in its place (why there is none).
    void showNothing(const QString& message);
    /// The path of another blow faintly behind; nullptr takes it away.
    void setGhost(const RockCurve* before);
    /// Marks a point of the path, in shown units, on the overlay layer; replots nothing.
    void setPoint(const std::optional<QPointF>& point);
    void setStyle(const PlotStyle& style);
    /// The whole path in view.
    void fit();
    QCPCurve* path() const { return m_path; }
    /// Those of pinned runs.
    const QVector<QCPCurve*>& runs() const { return m_runs->graphs(); }
    /// What the plot shows, in words, for assistive tools.
    QString textSummary() const { return m_summary; }

  private:
    QCPItemText* addLabel();
    void addDropLines();
    void nameNumbers(const RockCurve& curve);
    void placeLabels();
    void showRuns();
    void setMarksVisible(bool visible);

    QCustomPlot* m_plot;
    QCPCurve* m_path;
    QCPTextElement* m_caption;  // what the area is
    QCPCurve* m_ghost = nullptr;
    RunPaths* m_runs;
    QCPItemText* m_peakName;
    QCPItemText* m_residualName;
    QCPItemText* m_loadingName;
    QCPItemText* m_unloadingName;
    QCPItemTracer* m_peak;
    QCPItemTracer* m_residual;
    QCPItemTracer* m_point;
    QCPItemLine* m_toForceAxis;
    QCPItemLine* m_toPenetrationAxis;
    PlotMessage* m_message;
    RockCurve m_curve;
    PlotStyle m_style;
    QSizeF m_ghostSize;  // largest penetration and force of the ghost
    FittedView* m_view;
    QStringList m_peakNumbers;  // as they are named there
    QString m_summary;
};

}  // namespace drillwave
