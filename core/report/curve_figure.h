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

/// Returns the line that marks and sentences are about: that of the family value `here`, else the last line
/// with an answer; nullptr if no line has one.
const CurveLine* markedLine(const CurveStudy& study, std::optional<double> here);

/// Returns a line as a series of a figure whose axes are those of `question`: x in SI, y in the quantity of
/// its first column. NaN where there is no answer; without points if there is none anywhere.
FigureSeries curveSeries(const CurveLine& line, const CurveQuestion& question);

/// Returns a value of the first column of `question` as y of such a figure.
double curveOrdinate(const CurveQuestion& question, double value);

/// Returns the curves of all family values with the marks of markedLine(), the goal, and the presets that lie
/// in the range. `here` is the present scenario's value of the family [SI]. Numbers in names are in `style`.
StudyFigure curveFigure(const ComparedCurve& study, std::optional<double> here,
                        std::span<const Preset> presets, const ReadingStyle& style);

/// Returns the answer in sentences: where the marked line reaches the goal, its least and largest value,
/// where it is 1, and what is not known. Without a goal, a second sentence asks for one.
std::vector<Message> curveSentences(const ComparedCurve& study, std::optional<double> here,
                                    const ReadingStyle& style);

}  // namespace drillwave
