// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of a design study: objective, trade-off and causes of the scatter (theory §12).
#pragma once

#include "core/report/design_words.h"
#include "core/report/figure.h"

namespace drillwave {

/// Indices of the panels of designFigure(). Panels without data are hidden. Points of the panels refer to
/// rows of the study's table, which has one row for each design.
enum class DesignPanel {
    /// First objective over the last design variable, one curve for each combination of the others. The curve
    /// with the best design has a band from the 5 % to the 95 % quantile. For two design variables with
    /// numeric ranges and at least 4 and 2 values, there are colours over both variables instead.
    objective,
    tradeOff,  ///< second objective over the first objective
    causes,    ///< Sobol indices: share of the scatter of each output caused by each uncertain input
};

/// Selection of the marks in DesignPanel::objective. `withoutPresent` omits the mark of the present design.
/// The window then draws it itself, because it changes while the user edits the form.
enum class DesignMarks { all, withoutPresent };

/// Returns the figure of a design study. Requires a report with a best design.
StudyFigure designFigure(const DesignReport& report, const DesignNames& names,
                         DesignMarks marks = DesignMarks::all);

/// Returns an output value, converted from the unit of the study to the unit of the figure's axis. That unit
/// is a scale such as F0, or the SI unit if the output has no scale.
double designOrdinate(const DesignStudy& study, const Output& output, double value);

}  // namespace drillwave
