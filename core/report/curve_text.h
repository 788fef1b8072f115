// SPDX-License-Identifier: GPL-3.0-or-later
// Features of outputs along a parameter as text for people.
#pragma once

#include <string>

#include "core/report/curve_report.h"

namespace drillwave {

/// "105 MN/m", a value of an axis in its unit, rounded for people.
std::string valueText(const SweepAxis& axis, double value, int digits = 6);

/// What is worth telling of each line and output: a table of features, and where there is no smooth course or
/// no answer.
std::string curveText(const CurveReport& report);

}  // namespace drillwave
