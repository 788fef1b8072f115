// SPDX-License-Identifier: GPL-3.0-or-later
// Features of outputs along a parameter as text for people.
#pragma once

#include <string>

#include "core/report/curve_report.h"

namespace drillwave {

/// "105 MN/m", a value of an axis in its unit, rounded for people.
std::string valueText(const SweepAxis& axis, double value, int digits = 6);

/// "gamma = 0.1", which line of a family it is.
std::string familyText(const SweepAxis& family, double value);

/// What is worth telling of each line and output: where it takes the goal, a table of features, and where
/// there is no smooth course or no answer.
std::string curveText(const CurveReport& report);

}  // namespace drillwave
