// SPDX-License-Identifier: GPL-3.0-or-later
// An output along a parameter, a curve for each value of a family (paper, Fig. 6).
#pragma once

#include <memory>
#include <optional>

#include "ui/pages/curve/curve_picture.h"
#include "ui/pages/curve/preset_bands.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Draws the picture of a study along a parameter: fitted, the whole range is in view.
class CurvePlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit CurvePlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted, or axes or units changed.
    void present(const CurvePicture& picture);
    const CurvePicture& picture() const { return m_picture; }
    /// In the order of CurvePicture::lines.
    const QVector<QCPGraph*>& graphs() const { return m_graphs; }

    /// Target of a click: the nearest mark or curve within some pixels.
    struct Target {
        double x = 0;   ///< as shown
        int line = -1;  ///< of the picture; -1 away from all of them
        bool isMark = false;
    };
    Target targetAt(QPointF coordinates) const;
    /// Along the curves, to marks and extremes.
    KeyPlaces keyPlaces() const override;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void addRect();
    void makeGraphs();
    void showAxes();
    void dropMarks();

    QVector<QCPGraph*> m_graphs;
    QCPGraph* m_extremes = nullptr;
    QCPItemStraightLine* m_one = nullptr;
    QCPItemStraightLine* m_goal = nullptr;
    PresetBands* m_bands = nullptr;
    std::unique_ptr<CurveMarks> m_marks;
    CurvePicture m_picture;
};

}  // namespace drillwave
