// SPDX-License-Identifier: GPL-3.0-or-later
// A strength of rod or string in the plot of the largest stresses, with its name.
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

/// For rods a line across the plot, in tension and for the yield strength in compression as well; for drill
/// strings steps over neighbouring sections with the same strength.
class StrengthLines {
  public:
    enum class Kind { yield, fatigue };
    using StressText = std::function<QString(double shown)>;

    explicit StrengthLines(Kind kind) : m_kind(kind) {}
    /// Once, the lines first: the name is over them.
    void addLines(QCPAxisRect* rect);
    void addName(QCPItemText* name);

    void clear();
    /// The steps of a string whose waves are kept.
    void showSteps(const RodCurves& curves);
    /// The name with the strength, or that there are several, and of a rod the lines.
    void showName(const RodCurves& curves, const StressText& stress);
    void setStyle(const PlotStyle& style);

    /// Whether it is a strength of compression, too.
    bool isOfBoth() const { return m_kind == Kind::yield; }
    /// The name with possible places along its line; without any if it is not shown.
    PlacedLabel label(const RodCurves& curves) const;
    /// All strengths as shown.
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
