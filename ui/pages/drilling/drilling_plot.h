// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of many blows: penetration rate over a parameter and penetration blow by blow; gaps, their
// distribution and the energy as details.
#pragma once

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class MarchRects;
class ScanRects;

/// Shows a sequence of blows, a scan of sequences, or both. The mark "here" is at the scenario's value along
/// the scan.
class DrillingPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit DrillingPlot(QCustomPlot* plot);

    /// The view stays where it is unless it was fitted, or what it has in view is of other kinds.
    void present(const DrillingPicture& picture);
    /// Pinned runs: mean penetrations, and where they are along the scan, which may be nowhere.
    void showRuns(const QVector<RunMark>& means, const QVector<RunMark>& along);
    /// Shows or hides the plots of gaps, their distribution and the energy.
    void setDetailed(bool isDetailed);
    bool isDetailed() const { return m_isDetailed; }
    const DrillingPicture& picture() const { return m_picture; }
    const MarchRects& march() const { return *m_march; }
    const ScanRects& scan() const { return *m_scan; }
    /// Whether a place in that rect is one along the scan.
    bool isScan(const QCPAxisRect* rect) const;
    /// From value to value of the scan.
    KeyPlaces keyPlaces() const override;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void arrange();

    MarchRects* m_march;
    ScanRects* m_scan;
    QCPLayoutGrid* m_front;  // rates and penetrations
    QCPLayoutGrid* m_gaps;   // blow by blow, and over the scanned parameter
    bool m_isDetailed = false;
    DrillingPicture m_picture;
};

}  // namespace drillwave
