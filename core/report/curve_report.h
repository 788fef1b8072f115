// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs along a parameter as text, JSON and CSV.
#pragma once

#include <string>

#include "core/study/curve/curve.h"

namespace drillwave {

/// All that is reported.
struct CurveReport {
    CurveStudy study;
    double runTime = 0;        ///< [s]
    std::string scenarioText;  ///< gives the same scenario again
};

/// "beta = 0.5", a value of an axis in its unit, rounded for people.
std::string valueText(const SweepAxis& axis, double value, int digits = 6);

/// What is worth telling of each line and output: a table of features, and where there is no smooth course or
/// no answer.
std::string curveText(const CurveReport& report);

/// One object: `along`, `family`, `lines` with the features of each output, `scenario` and `units`.
std::string curveJson(const CurveReport& report);

/// A row for each point of each line: the value of the family, that of the parameter, the outputs; an empty
/// cell where there is no answer.
std::string curveCsv(const CurveStudy& study);

/// The rows of that.
std::uint64_t rowCount(const CurveStudy& study);

}  // namespace drillwave
