// SPDX-License-Identifier: GPL-3.0-or-later
// Where the lines of a study along a parameter take the goal: text, JSON and CSV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/curve/curve.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// How the CSV begins.
inline constexpr std::string_view goalCsvBegin = "goal,kind,direction,";

/// Returns the number of significant digits of goals and places.
int goalDigits(const ReadingStyle& style);

/// Returns a value of the question's output in its unit: "0.7", "240 kN".
std::string goalValue(const CurveQuestion& question, double value, const ReadingStyle& style);

/// Returns "cor = 0.7", "peak_force = 240 kN", in print "peak force = 240 kN". Requires a goal, as all that
/// follows does.
std::string goalTitle(const CurveQuestion& question, const ReadingStyle& style = plainStyle());

/// Returns that a line does not reach the goal, with the nearest value: "no beta from 0.1 to 10 gives cor =
/// 2: the nearest is 1.4140683, at 0.29982658".
Message missMessage(const CurveQuestion& question, const CurveLine& line, const ReadingStyle& style);

/// A table of the places of a line, whether there may be others, and where there is none the nearest value.
std::string goalText(const CurveQuestion& question, const CurveLine& line,
                     const ReadingStyle& style = plainStyle());

/// A sentence for each line that takes the goal nowhere; empty when all do.
std::vector<Message> goalProblems(const CurveStudy& study, const ReadingStyle& style = plainStyle());

/// `places` with `kind`, `complete`, and `nearest` where there is none.
JsonObject goalJson(const GoalAnswer& answer);

/// A row for each place of each line: the goal, kind and direction, the value of the family, place and error
/// in the unit of the parameter, the output and its error there, and what follows a leap.
std::string goalCsv(const CurveStudy& study);

}  // namespace drillwave
