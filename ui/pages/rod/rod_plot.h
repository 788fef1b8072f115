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
/// for the blow, dashed ones for the residual waves; the strengths and each extreme are marked. For drill
/// strings the hammer is at negative positions, joints have lines, and each section its strengths. Fitting
/// brings into view all curves, and strengths not far from them. A cursor marks a position and the stress
/// there at a chosen time.
class RodPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit RodPlot(QCustomPlot* plot);

    /// Shows the curves. The present zoom is kept, unless the view was fitted or the units changed.
    void present(const RodCurves& curves);
    /// Shows the curves of an earlier blow faintly and without legend entries; nullptr removes them.
    void setGhost(const RodCurves* before);

    /// Returns the marked extreme near a point (coordinates of the axes), else the largest stress at its
    /// position from the nearest curve. Nothing outside the rod.
    std::optional<RodForce> forceAt(QPointF coordinates) const;
    /// Returns the places for the keyboard: along the curves, with the marked extremes as targets.
    KeyPlaces keyPlaces() const override;
    QCPGraph* graph(Load line) const { return m_graphs[static_cast<std::size_t>(line)]; }
    /// Returns the curves of the pinned runs, one for each run. Each curve runs along the compression to the
    /// bit and back along the tension.
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
