// SPDX-License-Identifier: GPL-3.0-or-later
// A result over the gap of a pinned run, laid over that of the scenario.
#pragma once

#include <optional>
#include <stop_token>

#include "core/study/gap/gap_curve.h"
#include "ui/pages/study/run_studies.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// By scenarios without their gaps, which do not matter.
using RunGaps = RunStudies<Scenario, GapCurve>;

/// A scenario along the gap; nothing where it is not complete.
std::optional<GapCurve> runGap(const Scenario& scenario, const std::stop_token& stop);

/// An output over gaps from 0 to `to`, which is as shown; shown values are the dimensionless ones times the
/// factors.
GraphData runGapCurve(const GapCurve& curve, GapOutput output, double gapFactor, double valueFactor,
                      double to);

}  // namespace drillwave
