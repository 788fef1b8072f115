// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/impact_summary.h"

#include "core/contact/bilinear_law.h"
#include "core/wave/field/force_peaks.h"

namespace drillwave {

ImpactSummary summarize(const Impact& impact, const Problem& problem) {
    BilinearLaw<> rock(problem.law);
    rock.remember(impact.peakForce);
    return {.cor = impact.cor,
            .impulse = impact.impulse,
            .peakForce = impact.peakForce,
            .maxPenetration = rock.largestPenetration() * lawUnitOfPenetration,  // (T4)
            .residualPenetration = rock.residualPenetration() * lawUnitOfPenetration,
            .firstContactTime = impact.firstContactTime,
            .separationTime = impact.separationTime,
            .contactDuration = impact.contactDuration,
            .workRatio = impact.hammerWork * 2 * problem.transitTime(),  // [paper (2)]
            .energy = ledgerOf(impact, problem),
            .momentumResidual = 1 - impact.impulse - impact.finalMomentum,  // [paper (10)]
            .corError = impact.corError,
            .growth = impact.growth,
            .contacts = impact.contacts,
            .forcePeaks = {},
            .rodForces = {}};
}

ImpactSummary summarizeWithWaves(const Impact& impact, const Problem& problem, const WaveNumbers& wanted) {
    ImpactSummary summary = summarize(impact, problem);
    if (impact.incident.empty()) return summary;
    if (wanted.forcePeaks) summary.forcePeaks = forcePeaks(impact);
    summary.rodForces = largestRodForces(impact, problem.force(), wanted.forces);
    return summary;
}

}  // namespace drillwave
