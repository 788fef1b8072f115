// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a blow that follow from its waves, in memory that does not grow with the blow.
#pragma once

#include <functional>
#include <stop_token>

#include "core/blow/impact_summary.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Finds out by the exact solver whether the histories of a blow are too long to be kept for some numbers;
/// `solve` keeps what it solves. Leaves the ledger of such a blow, and of any other the least there is, which
/// took a few percent of the time of its histories.
bool isTooLongToKeep(const std::function<const Impact&(Detail)>& solve);

/// As summarizeWithWaves(), of such a blow: solves it once more. After a stop without the numbers of the
/// waves.
ImpactSummary summarizeInPassing(const Impact& impact, const Problem& problem, const WaveNumbers& wanted,
                                 const std::stop_token& stop);

}  // namespace drillwave
