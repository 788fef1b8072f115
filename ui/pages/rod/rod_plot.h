// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of the largest stresses along rod or string; the same code draws the page and files.
#pragma once

#include <array>
#include <optional>

#include "ui/pages/rod/rod_curves.h"
#include "ui/pages/rod/strength_lines.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Plot of the largest tension (above zero) and compression (below zero) over the position. Solid curves are
/// for the blow, dashed ones for the residual waves. The strengths and each extreme are marked. For drill
/// strings the hammer is at negative positions, joints have lines, and strengths are drawn for each section.
/// Zoom to fit shows all curves, and strengths not far above them. A cursor marks a position and the stress
/// there at a chosen time.
class RodPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit RodPlot(QCustomPlot* plot);

    /// Shows the curves. A zoom by the user is kept if the units are the same; otherwise all curves are
    /// brought into view.
    void present(const RodCurves& curves);
    /// Shows the curves of an earlier blow faintly, for comparison, without legend entries; nullptr removes
    /// them.
    void setGhost(const RodCurves* before);

    /// Returns the marked extreme near a point (coordinates of the axes). If there is none, returns the
    /// largest stress at its position from the nearest curve. Empty outside the rod.
    std::optional<RodForce> forceAt(QPointF coordinates) const;
    /// Returns the points that the keyboard can reach: along the curves. The key N jumps to the marked
    /// extremes.
    KeyPlaces keyPlaces() const override;
    QCPGraph* graph(Load line) const { return m_graphs[static_cast<std::size_t>(line)]; }
    /// Returns the curves of the pinned runs (results kept for comparison), one for each run. Each curve has
    /// the largest compression from the rear end to the bit, then the largest tension back.
    const QVector<QCPCurve*>& runs() const { return m_runs->graphs(); }

  private:
    struct Mark {
        QCPItemTracer* ring = nullptr;
        QCPItemText* number = nullptr;
    };

    void clear() override;
    void restyle() override;
    void setRanges() override;
    void addRunLegend();
    void addMark(Mark& mark);
    void showRuns();
    void nameAxes();
    void showLegendOf(const RodCurves& curves);
    void showSections();
    void styleSections();
    void placeMarks();
    void placeNames();
    void followLegend();
    void nameNumbers();
    void summarize();
    bool isNumbered(Load line) const;
    QString stressText(double stress) const;

    std::array<QCPGraph*, loads.size()> m_graphs{};
    std::array<Mark, loads.size()> m_marks;
    std::array<StrengthLines, 2> m_strengths{StrengthLines(StrengthLines::Kind::yield),
                                             StrengthLines(StrengthLines::Kind::fatigue)};
    QVector<QCPItemStraightLine*> m_joints;  // lines at the joints of a string
    QVector<QCPGraph*> m_ghosts;
    QCPLayoutGrid* m_header = nullptr;
    QCPLegend* m_runLegend = nullptr;  // in m_header while runs are shown
    RunPaths* m_runs = nullptr;
    RodCurves m_curves;
};

}  // namespace drillwave
