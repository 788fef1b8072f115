// SPDX-License-Identifier: GPL-3.0-or-later
// Impact force against penetration: the enclosed area is the energy left in the rock (paper, Fig. 1).
#pragma once

#include <QSizeF>
#include <optional>

#include "ui/pages/rock/rock_curve.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class LoadingLines;

/// Draws the path of a blow with its area, slopes and extremes named: fitted, the whole path is in view.
class RockPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit RockPlot(QCustomPlot* plot);

    /// Shows the curve; the view stays where it is unless it was fitted or the units changed.
    void present(const RockCurve& curve);
    /// Shows the path of another blow faintly; nullptr removes it.
    void setGhost(const RockCurve* before);
    /// Marks a point of the path, in shown units, on the overlay layer; replots nothing.
    void setPoint(const std::optional<QPointF>& point);
    QCPCurve* path() const { return m_path; }
    /// Names curve and axes.
    void name();
    /// Curves of pinned runs.
    const QVector<QCPCurve*>& runs() const { return m_runs->graphs(); }

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void nameNumbers(const RockCurve& curve);
    void placeLabels();
    void showRuns();
    void setMarksVisible(bool visible);

    QCPCurve* m_path;
    QCPCurve* m_ghost = nullptr;
    RunPaths* m_runs;
    LoadingLines* m_lines;
    QCPItemText* m_peakName;
    QCPItemText* m_residualName;
    QCPItemText* m_loadingName;
    QCPItemText* m_unloadingName;
    QCPItemTracer* m_peak;
    QCPItemTracer* m_residual;
    QCPItemTracer* m_point;
    QCPItemLine* m_toForceAxis;
    QCPItemLine* m_toPenetrationAxis;
    RockCurve m_curve;
    QSizeF m_ghostSize;         // largest penetration and force of the ghost
    QStringList m_peakNumbers;  // their texts
};

}  // namespace drillwave
