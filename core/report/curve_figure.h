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

/// Returns the line of a curve study whose features are marked in the figure and described in sentences. It
/// is the line with the family value `here`, otherwise the last line with a result. Returns nullptr if no
/// line has a result.
const CurveLine* markedLine(const CurveStudy& study, std::optional<double> here);

/// Returns one line of a curve study as a series for a figure. Its x is the parameter in SI, its y the first
/// output in the unit of the y axis (see curveOrdinate()). Points without a result are NaN; the series is
/// empty if no point has a result.
FigureSeries curveSeries(const CurveLine& line, const CurveQuestion& question);

/// Returns a value of the first output, converted from the unit of its column to the unit of the y axis of
/// curveFigure(). That unit is a scale such as F0, or the SI unit if the output has no dimensionless form.
double curveOrdinate(const CurveQuestion& question, double value);

/// Returns the figure of a curve study: one curve for each family value. The features of the line of
/// markedLine(), the goal, and the presets within the range are marked. `here` is the family value of the
/// present scenario [SI]. Numbers in names are formatted in `style`.
StudyFigure curveFigure(const ComparedCurve& study, std::optional<double> here,
                        std::span<const Preset> presets, const ReadingStyle& style);

/// Returns sentences on the line of markedLine(). They say where it reaches the goal, its smallest and
/// largest values, where it crosses the value 1, and where results are missing. Without a goal, the last
/// sentence asks the user to enter one.
std::vector<Message> curveSentences(const ComparedCurve& study, std::optional<double> here,
                                    const ReadingStyle& style);

}  // namespace drillwave
