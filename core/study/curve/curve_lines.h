// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the lines of a curve study in two passes: fits all cells, then solves points where the fit is not
// smooth.
#pragma once

#include <stop_token>

#include "core/study/curve/curve.h"

namespace drillwave {

/// Returns the result of a curve study. This is the main part of studyCurve(), with the same arguments, but
/// it requires problemsOf() to be empty.
CurveStudy followLines(const CurveQuestion& question, int jobs, std::stop_token stop,
                       const CurveProgress& progress);

}  // namespace drillwave
