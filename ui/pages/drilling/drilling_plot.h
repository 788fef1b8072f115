// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows: gaps and penetrations, the scatter and sequence of the gaps, the energy, and a scan over a
// parameter.
#pragma once

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class MarchRects;
class ScanRects;

/// Shows a march, a scan below it, or only one of them. A mark in the scan shows the value that the scenario
/// has.
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
    /// The keys go from value to value of the scan.
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
    bool m_isDetailed = true;
    DrillingPicture m_picture;
};

}  // namespace drillwave
