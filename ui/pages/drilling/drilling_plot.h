// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows: gaps and penetrations, the scatter and sequence of the gaps, the energy, and a scan over a
// parameter.
#pragma once

#include "ui/pages/drilling/drilling_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class MarchRects;
class ScanRects;

/// Plot of a blow sequence, of a scan, or of both. A mark in the scan shows the present value of the scanned
/// parameter.
class DrillingPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit DrillingPlot(QCustomPlot* plot);

    /// Shows the data. The present zoom is kept, unless the view was fitted or axes or units are different.
    void present(const DrillingPicture& picture);
    /// Shows pinned runs (results kept for comparison): their mean penetrations, and their places along the
    /// scan, which may be empty.
    void showRuns(const QVector<RunMark>& means, const QVector<RunMark>& along);
    /// Shows or hides the plots of gaps, of their distribution and of the energy.
    void setDetailed(bool isDetailed);
    bool isDetailed() const { return m_isDetailed; }
    const DrillingPicture& picture() const { return m_picture; }
    const MarchRects& march() const { return *m_march; }
    const ScanRects& scan() const { return *m_scan; }
    /// Returns whether the horizontal axis of `rect` is the scanned parameter.
    bool isScan(const QCPAxisRect* rect) const;
    /// Returns the places for the keyboard: the values of the scan.
    KeyPlaces keyPlaces() const override;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void arrange();

    MarchRects* m_march;
    ScanRects* m_scan;
    QCPLayoutGrid* m_front;  // grid with penetration rates and penetrations
    QCPLayoutGrid* m_gaps;   // grid with the gaps of each blow, and over the scanned parameter
    bool m_isDetailed = true;
    DrillingPicture m_picture;
};

}  // namespace drillwave
