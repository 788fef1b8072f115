// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a blow that follow from its waves, in memory that does not grow with the blow.
#pragma once

#include <stop_token>

#include "core/blow/impact_summary.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Whether the histories of a blow that the exact solver has solved are too long to be kept for some numbers.
bool isTooLongToKeep(const Impact& impact);

/// As summarizeWithWaves(), of such a blow solved with Detail::ledger: solves it once more. After a stop
/// without the numbers of the waves.
ImpactSummary summarizeInPassing(const Impact& impact, const Problem& problem, const WaveNumbers& wanted,
                                 const std::stop_token& stop);

}  // namespace drillwave
