// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/wave_numbers.h"

#include "core/wave/exact/exact_solver.h"
#include "core/wave/field/passing_waves.h"

namespace drillwave {

bool isTooLongToKeep(const std::function<const Impact&(Detail)>& solve) {
    const Impact& least = solve(Detail::cor);
    if (!least.isSolved() || least.pieces <= mostPiecesKept) return false;
    solve(Detail::ledger);
    return true;
}

ImpactSummary summarizeInPassing(const Impact& impact, const Problem& problem, const WaveNumbers& wanted,
                                 const std::stop_token& stop) {
    ImpactSummary summary = summarize(impact, problem);
    PassingWaves waves(impact, problem.force(), wanted.forces);
    Impact rest = marchInPassing(
        problem, impact.pieces, [&](Impact& recording) { return waves.take(recording); }, stop);
    if (!rest.isSolved()) return summary;
    waves.takeLast(rest);
    if (wanted.forcePeaks) summary.forcePeaks = waves.peaks();
    summary.setForces(waves.forces());
    return summary;
}

}  // namespace drillwave
