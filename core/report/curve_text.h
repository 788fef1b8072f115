// SPDX-License-Identifier: GPL-3.0-or-later
// Features of outputs along a parameter as text for people.
#pragma once

#include <string>

#include "core/report/curve_report.h"
#include "core/text/handy_text.h"

namespace drillwave {

inline constexpr int valueDigits = 6;

/// Returns a value of an axis as text in the axis's unit, with `digits` significant digits: "105 MN/m".
/// `value` is in SI; for an axis of words, such as pulse shapes, it is the index of a word.
std::string valueText(const SweepAxis& axis, double value, int digits = valueDigits,
                      const ReadingStyle& style = plainStyle());

/// Returns the name of the line for one family value: "gamma = 0.1".
std::string familyText(const SweepAxis& family, double value, const ReadingStyle& style = plainStyle());

/// Returns the line "and 7 more; --json has all" that follows a table of `most` rows out of `count`; empty if
/// count ≤ most.
std::string leftOutText(std::size_t count, std::size_t most, const ReadingStyle& style = plainStyle());

/// Returns the report as text. For each curve (one value of the family parameter), it lists where the goal is
/// reached. For each output, a table of features such as extremes follows, then the parameter ranges that are
/// known only at grid points or have no result.
std::string curveText(const CurveReport& report, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
