// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows: gaps and penetrations, how the gaps scatter and follow each other, where the energy goes, and a
// scan over a parameter.
#pragma once

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class MarchRects;
class ScanRects;

/// Shows a march, a scan below it, or one of them alone. One is at the value that the scenario has along the
/// scan.
class DrillingPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit DrillingPlot(QCustomPlot* plot);

    /// The view stays where it is unless it was fitted, or what it has in view is of other kinds.
    void present(const DrillingPicture& picture);
    /// Pinned runs: mean penetrations, and where they are along the scan, which may be nowhere.
    void showRuns(const QVector<RunMark>& means, const QVector<RunMark>& along);
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
    void arrange(bool hasMarch, bool hasScan);

    MarchRects* m_march;
    ScanRects* m_scan;
    DrillingPicture m_picture;
};

}  // namespace drillwave
