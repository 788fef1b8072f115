// SPDX-License-Identifier: GPL-3.0-or-later
// Figure and sentences about an output along a parameter.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/model/preset.h"
#include "core/report/figure.h"
#include "core/study/curve/compared_curve.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Returns the line of a curve study that marks and sentences describe. It is the line of the family value
/// `here`, or else the last line with a result. Returns nullptr if no line has a result.
const CurveLine* markedLine(const CurveStudy& study, std::optional<double> here);

/// Returns one line of a curve study as a series for a figure. Its x is the parameter in SI, its y the first
/// output in the unit of the y axis (see curveOrdinate()). Points without a result are NaN; the series is
/// empty if no point has a result.
FigureSeries curveSeries(const CurveLine& line, const CurveQuestion& question);

/// Returns `value`, a value of the first output in the unit of its column, in the unit of the y axis of
/// curveFigure(). That is a multiple of a scale such as F0, or SI for outputs without a dimensionless form.
double curveOrdinate(const CurveQuestion& question, double value);

/// Returns the figure of a curve study: one curve for each family value, marks on the line of markedLine(),
/// the goal, and the presets within the range. `here` is the family value of the present scenario [SI].
/// Numbers in names are in `style`.
StudyFigure curveFigure(const ComparedCurve& study, std::optional<double> here,
                        std::span<const Preset> presets, const ReadingStyle& style);

/// Returns sentences on the line of markedLine(): where it reaches the goal, its smallest and largest values,
/// where it crosses 1, and where results are missing. Without a goal, the last sentence asks the user to
/// enter one.
std::vector<Message> curveSentences(const ComparedCurve& study, std::optional<double> here,
                                    const ReadingStyle& style);

}  // namespace drillwave
