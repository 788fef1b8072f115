// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of one strength of rod or string in the plot of the largest stresses, with their label.
#pragma once

#include <qcustomplot.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "ui/pages/rod/rod_curves.h"
#include "ui/plot/label_places.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Lines of one strength in the plot of the largest stresses. For uniform rods they are straight lines: in
/// tension, and for the yield strength also in compression. For drill strings they are steps over
/// neighbouring sections with equal strength.
class StrengthLines {
  public:
    enum class Kind { yield, fatigue };
    using StressText = std::function<QString(double shown)>;

    explicit StrengthLines(Kind kind) : m_kind(kind) {}
    /// Adds the lines of the strength to an axis rect. Call this once, before addName(), so that the label is
    /// above the lines.
    void addLines(QCPAxisRect* rect);
    /// Sets the text item that shows the label of the lines. Call this once, after addLines().
    void addName(QCPItemText* name);

    void clear();
    /// Draws the strengths of the sections of a drill string as steps; draws nothing if its waves were not
    /// kept.
    void showSteps(const RodCurves& curves);
    /// Shows the label of the lines: the strength, or that several strengths differ. For a uniform rod it
    /// also shows the lines.
    void showName(const RodCurves& curves, const StressText& stress);
    void setStyle(const PlotStyle& style);

    /// Returns whether the strength applies to compression as well as tension.
    bool isOfBoth() const { return m_kind == Kind::yield; }
    /// Returns the label with the places along the line where it may stand, so that labels do not overlap.
    /// There are no places if it is hidden.
    PlacedLabel label(const RodCurves& curves) const;
    /// Returns all strengths of this kind, in the unit shown.
    std::vector<double> values(const RodCurves& curves) const;

  private:
    std::optional<double> RodStretch::*ofStretch() const;
    void place(const RodCurves& curves, const std::optional<double>& value, const StressText& stress);
    const RodStretch* longest(const RodCurves& curves) const;
    void placeOverLongest(const RodCurves& curves, const StressText& stress);

    Kind m_kind;
    QCPAxisRect* m_rect = nullptr;
    std::array<QCPItemStraightLine*, 2> m_lines{};
    QCPItemText* m_name = nullptr;
    QVector<QCPItemLine*> m_steps;
    QPen m_pen;
};

}  // namespace drillwave
