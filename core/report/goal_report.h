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

/// "cor = 0.7", "peak_force = 240 kN". Requires a goal, as all that follows does.
std::string goalTitle(const CurveQuestion& question, const ReadingStyle& style = plainStyle());

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
