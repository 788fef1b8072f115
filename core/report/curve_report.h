// SPDX-License-Identifier: GPL-3.0-or-later
// A study along a parameter with what is reported about it: JSON and CSV.
#pragma once

#include <cstdint>
#include <string>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Contents of the report of a curve study.
struct CurveReport {
    CurveStudy study;
    double runTime = 0;        ///< computing time [s]
    std::string scenarioText;  ///< scenario file that reproduces the scenario
};

/// Returns the curves as CSV with one row for each point of each line: family value (if any), parameter
/// value, then the outputs. Cells without a result are empty.
std::string curveCsv(const CurveStudy& study);

/// Returns the number of rows of curveCsv(), without the header.
std::uint64_t rowCount(const CurveStudy& study);

/// Returns the report as one JSON object with the members `along`, `family`, `lines` (with the features of
/// each output), `scenario` and `units`, among others.
std::string curveJson(const CurveReport& report);

}  // namespace drillwave
