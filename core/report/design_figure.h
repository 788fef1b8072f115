// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of a design study: objective, trade-off and causes of the scatter (theory §12).
#pragma once

#include "core/report/design_words.h"
#include "core/report/figure.h"

namespace drillwave {

/// Panels of designFigure(); empty ones are hidden. The table of the study has a row for each design.
enum class DesignPanel {
    /// First objective over the last design variable, with the band from 5 % to 95 % for the best design. For
    /// two ranges of numbers with enough values, a field over both.
    objective,
    tradeOff,  ///< second objective over the first
    causes,    ///< Sobol indices: shares of the uncertain inputs in the scatter
};

/// Marks in the panel of the objective. The window draws the present design itself: it moves with the form.
enum class DesignMarks { all, withoutPresent };

/// Returns the figure of a study. Requires a report with a best design.
StudyFigure designFigure(const DesignReport& report, const DesignNames& names,
                         DesignMarks marks = DesignMarks::all);

/// Returns an output as a figure has it: a multiple of its scale, or in SI if it has none. `value` is in the
/// units of the study.
double designOrdinate(const DesignStudy& study, const Output& output, double value);

}  // namespace drillwave
