// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's closed form of the impact force, drawn with the exact force where it is valid.
#pragma once

#include <optional>

#include "core/wave/problem.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Impact force over time by the closed form (analytical solution) [paper (11)] [paper (12)] [paper (14)], in
/// the units shown.
struct ClosedFormCurve {
    GraphData force;
    double error = 0;  ///< bound on the error of the coefficient of restitution of the closed form
};

/// Returns the closed form of the impact force; nothing if it is not valid for this problem
/// (core/wave/closed/closed_form.h). `timeEnd` is the end of the other curves, in the units shown.
std::optional<ClosedFormCurve> closedFormCurve(const Problem& problem, const ShownUnits& units,
                                               double timeEnd);

}  // namespace drillwave
