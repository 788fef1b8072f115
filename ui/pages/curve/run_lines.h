// SPDX-License-Identifier: GPL-3.0-or-later
// A result along a parameter for a pinned run, laid over that of the scenario.
#pragma once

#include <optional>
#include <stop_token>

#include "core/study/curve/sampled_curve.h"
#include "ui/pages/study/run_studies.h"

namespace drillwave {

using RunLines = RunStudies<CurveQuestion, CurveStudy>;

/// Returns the page's question for the scenario of a run: one line, for the run's value of the family.
/// Nothing where the run has no such parameter or no such output.
std::optional<CurveQuestion> runLineQuestion(const CurveQuestion& page, const Scenario& run);

/// Works only on the calling thread. Nothing after a stop.
std::optional<CurveStudy> runLine(const CurveQuestion& question, const std::stop_token& stop);

}  // namespace drillwave
