// SPDX-License-Identifier: GPL-3.0-or-later
// A study along a parameter with what is reported about it: JSON and CSV.
#pragma once

#include <cstdint>
#include <string>

#include "core/study/curve/curve.h"

namespace drillwave {

/// All that is reported.
struct CurveReport {
    CurveStudy study;
    double runTime = 0;        ///< [s]
    std::string scenarioText;  ///< gives the same scenario again
};

/// A row for each point of each line: the value of the family, that of the parameter, the outputs; an empty
/// cell where there is no answer.
std::string curveCsv(const CurveStudy& study);

/// The rows of that.
std::uint64_t rowCount(const CurveStudy& study);

/// One object: `along`, `family`, `lines` with the features of each output, `scenario` and `units`.
std::string curveJson(const CurveReport& report);

}  // namespace drillwave
