// SPDX-License-Identifier: GPL-3.0-or-later
// Impact force against penetration: the enclosed area is the energy left in the rock (paper, Fig. 1).
#pragma once

#include <QSizeF>
#include <optional>

#include "ui/pages/rock/rock_curve.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class LoadingLines;

/// Plot of the force–penetration path of a blow, with its area, slopes and extremes labelled. Zoom to fit
/// shows the whole path.
class RockPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit RockPlot(QCustomPlot* plot);

    /// Shows the path of a blow. A zoom by the user is kept if the units are the same; otherwise the whole
    /// path is brought into view.
    void present(const RockCurve& curve);
    /// Shows the path of an earlier blow faintly, for comparison; nullptr removes it.
    void setGhost(const RockCurve* before);
    /// Marks a point of the path, in the units shown, on the overlay layer; empty removes the mark. Does not
    /// replot.
    void setPoint(const std::optional<QPointF>& point);
    QCPCurve* path() const { return m_path; }
    /// Sets the names of curve and axes in the present language.
    void name();
    /// Returns the curves of the pinned runs (results kept for comparison).
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
    QSizeF m_ghostSize;         // largest penetration and force of the earlier blow
    QStringList m_peakNumbers;  // texts of m_peakName
};

}  // namespace drillwave
