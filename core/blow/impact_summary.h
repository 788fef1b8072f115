// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of one solved blow (files §4), dimensionless.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/model/scenario.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

// Balance of the hammer work

/// Energies after a blow as shares of the hammer work W, or of the hammer energy E0 of a drill string. For a
/// uniform rod, the shares in rock, rebound and waves add up to 1, apart from the error `residual`.
struct EnergyLedger {
    /// Share of the hammer work W (drill string: hammer energy E0) that stays in the rock.
    double rockWork = 0;
    /// Share of the hammer work W (drill string: hammer energy E0) in the motion of rod or string as a whole,
    /// p²/(2m) with momentum p and mass m.
    double reboundEnergy = 0;
    /// Share of the hammer work W (drill string: hammer energy E0) in the waves that remain in rod or string.
    double residualWaveEnergy = 0;
    /// Error of the energy balance, as a share of the hammer work W (drill string: hammer energy E0).
    double residual = 0;
    bool operator==(const EnergyLedger&) const = default;
};

/// Returns the energies after a blow as shares of the hammer work. Requires an impact solved with
/// Detail::ledger or more.
EnergyLedger ledgerOf(const Impact& impact, const Problem& problem);

/// Results of one solved blow (files §4), dimensionless.
struct ImpactSummary {
    /// Coefficient of restitution e of rod or string.
    double cor = 0;
    /// Impulse on the rock, in units of I0 (for a hammer, of its momentum p0); 1 + e for a uniform rod with
    /// the coefficient of restitution e.
    double impulse = 0;
    /// Largest impact force, in units of F0.
    double peakForce = 0;
    /// Largest penetration of the bit, in units of d0.
    double maxPenetration = 0;
    /// Residual penetration after the blow, in units of d0.
    double residualPenetration = 0;
    /// Time of the first contact of bit and rock since the start of the blow, in units of t0.
    double firstContactTime = 0;
    /// Time of the last separation of bit and rock since the start of the blow, in units of t0.
    double separationTime = 0;
    /// Sum of the durations of all contacts of bit and rock, in units of t0.
    double contactDuration = 0;
    /// Work ratio W/W0 [paper (2)] of a prescribed force: the hammer work W over W0 = m v0²/2, with the mass
    /// m of the rod and v0 = I0/m. For a hammer, the share of its energy that it transfers.
    double workRatio = 0;
    /// Shares of the hammer work in rock, rebound and waves after the blow.
    EnergyLedger energy;
    /// Error of the momentum balance, as a share of the impulse I0 of the hammer force, or of the momentum p0
    /// of a hammer.
    double momentumResidual = 0;
    /// Upper bound of the absolute error of the coefficient of restitution `cor`.
    double corError = 0;
    /// Factor by which later contacts of bit and rock may amplify rounding errors of earlier ones; ≥ 1
    /// (Impact::growth).
    double growth = 1;
    /// Number of separate contacts of bit and rock.
    int contacts = 0;
    /// Number of peaks of the impact force (see forcePeaks()); nothing unless the histories were evaluated.
    std::optional<int> forcePeaks = {};
    /// Largest forces in a uniform rod, in units of F0; nothing unless requested.
    std::optional<RodForces> rodForces = {};

    /// Momentum that hammer or force transfers to rod or string, in units of I0, or of p0 for a hammer.
    double transferred = 1;
    /// Work A(Fm) on the rock up to the largest force, as a share of the hammer work.
    double loadingWork = 0;
    /// Estimated error of the energy shares of a drill string, such as energy.rockWork. It is 0 for a uniform
    /// rod, for which this error is not estimated.
    double efficiencyError = 0;
    /// Stated error of the largest stresses of a string, as a share of each stress.
    double stressError = 0;

    // Energies are in units of W, or of E0 for a hammer; momenta in units of I0, or of p0 for a hammer
    /// Momentum of rod or string after the blow, positive towards the rock, in units of I0, or of the
    /// momentum p0 of a hammer.
    double stringMomentum = 0;
    /// Energy of string or rod after the blow, as a share of the hammer work W (drill string: hammer energy
    /// E0).
    double stringEnergy = 0;
    /// Energy lost in joints, as a share of the hammer work W (drill string: hammer energy E0).
    double jointLoss = 0;
    /// Energy lost by attenuation in sections, as a share of the hammer work W (drill string: hammer energy
    /// E0).
    double rodLoss = 0;
    /// Velocity of the hammer after the blow, in units of its impact velocity v0, positive away from the
    /// rock; 0 for a prescribed force.
    double hammerReboundVelocity = 0;
    /// Energy of the hammer's rebound motion as a rigid body, as a share of the hammer energy E0.
    double hammerReboundEnergy = 0;
    /// Energy of the waves that remain in the hammer, as a share of the hammer energy E0.
    double hammerWaveEnergy = 0;
    /// Elastic energy that remains in the contact stiffness of the hammer face, as a share of the hammer
    /// energy E0.
    double faceEnergy = 0;
    /// Time at which hammer and string first separate, in units of t0; NaN if they do not.
    double faceSeparationTime = Impact::never;
    /// Time after the start of the blow at which the computation of a drill string ended, in units of t0.
    double endTime = 0;

    /// Largest stresses over all sections of hammer and string, in units of F0/A of the rod, if requested.
    /// The stresses during the blow and after it are separate values; the latter are missing if the
    /// computation ended too early.
    OfLoads<std::optional<double>> largest = {};

    /// Returns the energy in the rock plus that of the hammer's rebound, as a share of the hammer work W
    /// (drill string: hammer energy E0).
    double efficiencyRecovered() const { return energy.rockWork + hammerReboundEnergy; }
    /// Sets the largest forces of a uniform rod, and from them the largest stresses.
    void setForces(const RodForces& forces);
};

/// Returns the results of a blow solved with Detail::ledger or more. With less detail, only the results that
/// this detail includes are valid; the others are NaN or zero. With Detail::cor these are `cor`, `impulse`
/// and `corError`.
ImpactSummary summarize(const Impact& impact, const Problem& problem);

/// Returns the energy to which all energy shares of the summary refer, in units of W0 = m v0²/2. It is the
/// work of a prescribed force, or 1 for a hammer, whose energy is W0.
double drivenEnergy(const ImpactSummary& summary, const Scenario& scenario);

/// Choice of optional results that need the histories of the waves. Each result takes additional computing
/// time.
struct WaveNumbers {
    /// Whether the peaks of the impact force are counted, which needs the histories of the waves.
    bool forcePeaks = true;
    /// Selection of the largest forces in the rod to be computed.
    RodForceChoice forces = {};
};

/// Returns the results of a solved blow. After solving with Detail::histories, they include those requested
/// by `wanted`: number of peaks of the impact force, and largest forces in the rod.
ImpactSummary summarizeWithWaves(const Impact& impact, const Problem& problem,
                                 const WaveNumbers& wanted = {});

// Numbers of the waves of a blow in limited memory, however long its histories are

/// Returns whether the histories of a blow are too long to be kept; false if it cannot be solved. `solve` has
/// to solve the blow with the exact solver, keep the solution and return it. It is called with Detail::cor,
/// which takes a few percent of the time of histories. If the histories are too long, it is called again with
/// Detail::ledger, for summarizeInPassing().
bool isTooLongToKeep(const std::function<const Impact&(Detail)>& solve);

/// Returns the results of a blow whose histories are too long to be kept. The blow is solved a second time,
/// and its waves are evaluated during the computation. The results are as those of summarizeWithWaves().
/// After a stop request, the results requested by `wanted` are missing.
ImpactSummary summarizeInPassing(const Impact& impact, const Problem& problem, const WaveNumbers& wanted,
                                 const std::stop_token& stop);

}  // namespace drillwave
