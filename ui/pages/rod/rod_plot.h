// SPDX-License-Identifier: GPL-3.0-or-later
// The largest stresses along rod or string: the same drawing code for the page and for files.
#pragma once

#include <array>
#include <optional>

#include "ui/pages/rod/rod_curves.h"
#include "ui/pages/rod/strength_lines.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Largest tension above and largest compression below zero over the position in the rod, during the blow
/// (solid) and of the residual waves (dashed), with the strengths of the rod and a mark at each extreme. A
/// string has its hammer at negative positions, a line where sections meet, and the strengths of each.
/// Fitted, all curves are in view, and the strengths that are not far from them. A cursor marks a position
/// and, at a chosen time, the stress there and then.
class RodPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit RodPlot(QCustomPlot* plot);

    /// Shows the curves; the view stays where it is unless it was fitted or the units changed.
    void present(const RodCurves& curves);
    /// Shows the curves of another blow faintly, in no legend; nullptr removes them.
    void setGhost(const RodCurves* before);

    /// Returns the extreme that is marked near a point of the plot, or the largest stress at that position by
    /// the nearest curve. Nothing beside the rod.
    std::optional<RodForce> forceAt(QPointF coordinates) const;
    /// Along the curves, to the extremes that are marked.
    KeyPlaces keyPlaces() const override;
    QCPGraph* graph(Load line) const { return m_graphs[static_cast<std::size_t>(line)]; }
    /// Curves of pinned runs: compression to the bit and tension back from it.
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
    QVector<QCPItemStraightLine*> m_joints;  // of a string
    QVector<QCPGraph*> m_ghosts;
    QCPLayoutGrid* m_header = nullptr;
    QCPLegend* m_runLegend = nullptr;  // in the header while there are runs
    RunPaths* m_runs = nullptr;
    RodCurves m_curves;
};

}  // namespace drillwave
