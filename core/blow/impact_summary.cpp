// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/impact_summary.h"

#include "core/contact/contact_law.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/field/passing_waves.h"

namespace drillwave {

namespace {

/// Adds the rebound and the waves of a followed hammer.
void addHammer(ImpactSummary& summary, const Impact& impact, const Problem& problem) {
    const double mass = impact.hammerImpulse / problem.velocity();
    const double back = -impact.hammerMomentum / mass;
    summary.hammerReboundVelocity = back / problem.velocity();
    summary.hammerReboundEnergy = mass * back * back / 2 / impact.hammerWork;
    summary.hammerWaveEnergy = impact.hammerEnergy / impact.hammerWork - summary.hammerReboundEnergy;
    summary.faceEnergy = impact.faceEnergy / impact.hammerWork;
    summary.faceSeparationTime = impact.faceSeparation;
}

}  // namespace

// Energies of `impact` are in I0²/(Z t0).
EnergyLedger ledgerOf(const Impact& impact, const Problem& problem) {
    const double work = impact.hammerWork;
    // p²/(2m); e of a string with losses is from the impulse on the rock, which is not its own momentum
    const double momentum = losesWaves(problem) ? impact.finalMomentum : impact.cor * impact.faceImpulse;
    const double rebound = momentum * momentum / (2 * problem.mass());
    return {.rockWork = impact.rockWork / work,
            .reboundEnergy = rebound / work,
            .residualWaveEnergy = (impact.finalEnergy - rebound) / work,
            .residual = (impact.rockWork + impact.energyLeft() - work) / work};
}

void ImpactSummary::setForces(const RodForces& forces) {
    rodForces = forces;
    largest = eachOf(forces, [](const RodForce& force) { return std::optional(force.size); });
}

double drivenEnergy(const ImpactSummary& summary, const Scenario& scenario) {
    return isForced(scenario) ? summary.workRatio : 1;
}

ImpactSummary summarize(const Impact& impact, const Problem& problem) {
    ContactLaw<> rock(problem.law);
    rock.rememberAcross(impact.peakForce);
    const double work = impact.hammerWork, given = impact.hammerImpulse;
    ImpactSummary summary{.cor = impact.cor,
                          .impulse = impact.impulse / given,
                          .peakForce = impact.peakForce,
                          .maxPenetration = rock.largestPenetration() * lawUnitOfPenetration,  // (T4)
                          .residualPenetration = rock.residualPenetration() * lawUnitOfPenetration,
                          .firstContactTime = impact.firstContactTime,
                          .separationTime = impact.separationTime,
                          .contactDuration = impact.contactDuration,
                          .energy = ledgerOf(impact, problem),
                          .momentumResidual = impact.momentumResidual(),  // [paper (10)]
                          .corError = impact.corError,
                          .growth = impact.growth,
                          .contacts = impact.contacts};
    // for a hammer, the share that it has transferred [paper (2)]
    summary.workRatio = problem.isForced() ? work * 2 * problem.mass()
                                           : 1 - impact.hammerEnergy / work - impact.faceEnergy / work;
    summary.transferred = impact.faceImpulse / given;
    summary.loadingWork = rock.loadingWork() / work;
    summary.efficiencyError = impact.efficiencyError;
    summary.stringMomentum = impact.finalMomentum / given;
    summary.stringEnergy = impact.finalEnergy / work;
    summary.jointLoss = impact.jointLoss / work;
    summary.rodLoss = impact.rodLoss / work;
    summary.endTime = impact.endTime;
    if (!problem.isForced()) addHammer(summary, impact, problem);
    return summary;
}

ImpactSummary summarizeWithWaves(const Impact& impact, const Problem& problem, const WaveNumbers& wanted) {
    ImpactSummary summary = summarize(impact, problem);
    if (impact.incident.empty()) return summary;
    if (wanted.forcePeaks) summary.forcePeaks = forcePeaks(impact);
    summary.setForces(largestRodForces(impact, problem.force(), wanted.forces));
    return summary;
}

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
