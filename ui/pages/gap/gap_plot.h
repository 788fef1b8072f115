// SPDX-License-Identifier: GPL-3.0-or-later
// An output over one period of the gap, and its distribution beside it on the same axis (paper, Fig. 8).
#pragma once

#include "ui/pages/gap/gap_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Draws the picture of a study of the gap: fitted, the whole period is in view.
class GapPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit GapPlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted, or output or units changed.
    void present(const GapPicture& picture);
    QCPGraph* graph() const { return m_graph; }
    /// Whether a point of the plot is beside the curve, on the distribution.
    bool isDistribution(const QCPAxisRect* rect) const { return rect == m_beside; }
    /// Along the curves over the gap, to the marks.
    KeyPlaces keyPlaces() const override;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void addRects();
    void linkAxes();
    void addLines();
    void placeBands();
    void breakCaption();
    void showSpread();
    void setFramesVisible(bool visible);
    QString summary() const;

    QCPAxisRect* m_beside = nullptr;  // shares of gaps over value
    QCPGraph* m_graph = nullptr;      // value over gap
    QCPCurve* m_shares = nullptr;
    QCPCurve* m_below = nullptr;
    QCPItemRect* m_bands[2] = {};  // super rebound, in both rects
    QCPItemText* m_bandName = nullptr;
    QCPItemStraightLine* m_lines[2][3] = {};  // 5 %, mean, 95 %, in both rects
    QCPItemText* m_lineNames[3] = {};
    CurveMarks* m_marks = nullptr;
    GapPicture m_picture;
};

}  // namespace drillwave
