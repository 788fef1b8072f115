// SPDX-License-Identifier: GPL-3.0-or-later
// Report of the parameter values at which the curves take a goal value, as text, JSON and CSV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/curve/curve.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// First characters of a CSV file written by goalCsv(). The program uses them to recognise such a file of an
/// earlier run.
inline constexpr std::string_view goalCsvBegin = "goal,kind,direction,";

/// Returns the number of significant digits for a goal value and the parameter values that give it: 5 in
/// print, otherwise 8.
int goalDigits(const ReadingStyle& style);

/// Returns `value`, a value of the first output of `question`, as text with its unit: "0.7", "240 kN".
std::string goalValue(const CurveQuestion& question, double value, const ReadingStyle& style);

/// Returns the goal in words, such as "cor = 0.7" or, in print, "peak force = 240 kN". Requires that the
/// question has a goal.
std::string goalTitle(const CurveQuestion& question, const ReadingStyle& style = plainStyle());

/// Returns the message that a line does not reach the goal, with the nearest value. Example: "no beta from
/// 0.1 to 10 gives cor = 2: the nearest is 1.4140683, at 0.29982658".
Message missMessage(const CurveQuestion& question, const CurveLine& line, const ReadingStyle& style);

/// Returns a table of the parameter values at which an output takes the goal value. The line after it states
/// whether there may be more such values. If there are none, it states where the output is nearest to the
/// goal. Requires a question with a goal.
std::string goalText(const CurveQuestion& question, const CurveLine& line,
                     const ReadingStyle& style = plainStyle());

/// Returns one sentence for each curve that nowhere takes the goal value; empty if all do. Requires that the
/// question has a goal.
std::vector<Message> goalProblems(const CurveStudy& study, const ReadingStyle& style = plainStyle());

/// Returns a JSON object with the members `reached`, `complete`, `places` (parameter values that give the
/// goal, each with its `kind`) and `nearest`. `nearest` is null if a parameter value gives the goal, or if
/// the curve has no result.
JsonObject goalJson(const GoalAnswer& answer);

/// Returns one CSV row for each parameter value at which a curve takes or jumps over the goal value. Columns:
/// goal, kind and direction of the crossing, family value (if any), parameter value, its error. The output,
/// its error, and its value after a jump follow. Requires that the question has a goal.
std::string goalCsv(const CurveStudy& study);

}  // namespace drillwave
