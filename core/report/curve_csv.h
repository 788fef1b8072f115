// SPDX-License-Identifier: GPL-3.0-or-later
// The points of outputs along a parameter as CSV.
#pragma once

#include <cstdint>
#include <string>

#include "core/study/curve/curve.h"

namespace drillwave {

/// A row for each point of each line: the value of the family, that of the parameter, the outputs; an empty
/// cell where there is no answer.
std::string curveCsv(const CurveStudy& study);

/// The rows of that.
std::uint64_t rowCount(const CurveStudy& study);

}  // namespace drillwave
