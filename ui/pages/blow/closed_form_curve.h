// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's closed form of the impact force, to be drawn over the exact one where it holds.
#pragma once

#include <optional>

#include "core/wave/problem.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Impact force by the closed form [paper (11)] [paper (12)] [paper (14)], in shown units.
struct ClosedFormCurve {
    GraphData force;
    double error = 0;  ///< bound on the error of its coefficient of restitution
};

/// Returns nothing if the closed form does not hold (core/wave/closed/closed_form.h). `timeEnd`, in shown
/// units, is the end of the other curves.
std::optional<ClosedFormCurve> closedFormCurve(const Problem& problem, const ShownUnits& units,
                                               double timeEnd);

}  // namespace drillwave
