// SPDX-License-Identifier: GPL-3.0-or-later
// Features of outputs along a parameter as text for people.
#pragma once

#include <string>

#include "core/report/curve_report.h"
#include "core/text/handy_text.h"

namespace drillwave {

inline constexpr int valueDigits = 6;

/// "105 MN/m", a value of an axis in its unit, rounded for people.
std::string valueText(const SweepAxis& axis, double value, int digits = valueDigits,
                      const ReadingStyle& style = plainStyle());

/// "gamma = 0.1", which line of a family it is.
std::string familyText(const SweepAxis& family, double value, const ReadingStyle& style = plainStyle());

/// A line that tells how many of a table are left out where there are more than `most`.
std::string leftOutText(std::size_t count, std::size_t most, const ReadingStyle& style = plainStyle());

/// Returns the features of each line and output: places of the goal, a table of features, and ranges where
/// there is no smooth course or no answer.
std::string curveText(const CurveReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
