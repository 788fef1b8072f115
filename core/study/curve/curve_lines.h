// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a curve, pass by pass: cells fitted, and what is not smooth solved at points.
#pragma once

#include <stop_token>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Studies the curves; see studyCurve().
CurveStudy followLines(const CurveQuestion& question, int jobs, std::stop_token stop,
                       const CurveProgress& progress);

}  // namespace drillwave
