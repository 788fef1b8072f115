// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of files §4 for one solved blow, dimensionless.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

// Where the work of the hammer went.

/// Shares of the hammer work W, or of the energy E0 of a hammer that is followed; of a uniform rod the first
/// three together are 1 + residual.
struct EnergyLedger {
    double rockWork = 0;            ///< left in the rock [W]
    double reboundEnergy = 0;       ///< of the rod moving back as a whole [W]
    double residualWaveEnergy = 0;  ///< of the waves left in the rod [W]
    double residual = 0;            ///< error of the balance [W]
    bool operator==(const EnergyLedger&) const = default;
};

/// Requires an impact solved with Detail::ledger or more.
EnergyLedger ledgerOf(const Impact& impact, const Problem& problem);

/// Everything of files §4, dimensionless.
struct ImpactSummary {
    double cor = 0;
    double impulse = 0;
    double peakForce = 0;            ///< F0
    double maxPenetration = 0;       ///< d0
    double residualPenetration = 0;  ///< d0
    double firstContactTime = 0;     ///< t0
    double separationTime = 0;       ///< t0
    double contactDuration = 0;      ///< t0
    double workRatio = 0;            ///< W/W0 [paper (2)]
    EnergyLedger energy;
    double momentumResidual = 0;  ///< of I0
    double corError = 0;
    double growth = 1;                        ///< Impact::growth
    int contacts = 0;                         ///< separate contacts
    std::optional<int> forcePeaks = {};       ///< forcePeaks(), where the histories were kept
    std::optional<RodForces> rodForces = {};  ///< [F0] of a uniform rod, if requested

    double transferred = 1;      ///< momentum that the drive transfers to rod or string [I0; p0]
    double loadingWork = 0;      ///< A(Fm), work on the rock up to the largest force, of the hammer work
    double efficiencyError = 0;  ///< stated error of energy.rockWork and other shares, where cells give it
    double stressError = 0;      ///< stated error of the largest stresses of a string, as a share of them

    // Energies in W, or in E0 of a followed hammer; momenta in I0, or in p0 of a followed hammer
    double stringMomentum = 0;                  ///< towards the rock
    double stringEnergy = 0;                    ///< of string or rod
    double jointLoss = 0;                       ///< energy lost in joints
    double rodLoss = 0;                         ///< energy lost on the way through sections
    double hammerReboundVelocity = 0;           ///< of a followed hammer, away from the rock [v0]
    double hammerReboundEnergy = 0;             ///< energy of that motion
    double hammerWaveEnergy = 0;                ///< of waves left in the hammer
    double faceEnergy = 0;                      ///< in the stiffness of the faces
    double faceSeparationTime = Impact::never;  ///< when hammer and string first part [t0]
    double endTime = 0;                         ///< to when a string was followed [t0]

    /// Largest stresses over all sections of hammer and string [F0/A of the rod], if requested: while the
    /// blow lasts, and later if it was followed that long.
    OfLoads<std::optional<double>> largest = {};

    double efficiencyRecovered() const { return energy.rockWork + hammerReboundEnergy; }
    /// Sets the forces of a uniform rod.
    void setForces(const RodForces& forces);
};

/// Summarises an impact solved with Detail::ledger or more. With less detail only the numbers of that
/// detail mean anything; the rest is NaN or zero. With Detail::cor these are `cor`, `impulse` and
/// `corError`.
ImpactSummary summarize(const Impact& impact, const Problem& problem);

/// Returns the energy that shares of energy refer to [W0]: the energy of a hammer that is followed, or the
/// work of the force.
double drivenEnergy(const ImpactSummary& summary, const Scenario& scenario);

/// Which numbers of the waves are wanted: each takes some time.
struct WaveNumbers {
    bool forcePeaks = true;
    RodForceChoice forces = {};
};

/// Summarises with the requested peaks of the impact force and largest forces in the rod, if the impact was
/// solved with Detail::histories.
ImpactSummary summarizeWithWaves(const Impact& impact, const Problem& problem,
                                 const WaveNumbers& wanted = {});

// The numbers of a blow that follow from its waves, in memory that does not grow with the blow.

/// Returns whether the histories of a blow are too long to be kept for some numbers, by the exact solver;
/// `solve` keeps its solution. For such a blow this is the one with Detail::ledger, otherwise with
/// Detail::cor, which takes a few percent of the time of its histories.
bool isTooLongToKeep(const std::function<const Impact&(Detail)>& solve);

/// Summarises such a blow as summarizeWithWaves() does, solving it again. After a stop the numbers of the
/// waves are missing.
ImpactSummary summarizeInPassing(const Impact& impact, const Problem& problem, const WaveNumbers& wanted,
                                 const std::stop_token& stop);

}  // namespace drillwave
