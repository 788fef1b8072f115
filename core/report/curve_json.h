// SPDX-License-Identifier: GPL-3.0-or-later
// Features of outputs along a parameter as JSON.
#pragma once

#include <string>

#include "core/report/curve_report.h"

namespace drillwave {

/// One object: `along`, `family`, `lines` with the features of each output, `scenario` and `units`.
std::string curveJson(const CurveReport& report);

}  // namespace drillwave
