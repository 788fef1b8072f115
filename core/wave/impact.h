// SPDX-License-Identifier: GPL-3.0-or-later
// One blow, solved: the common result of every solver, all quantities dimensionless.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/numeric/piecewise.h"
#include "core/text/message.h"
#include "core/wave/section_forces.h"

namespace drillwave {

/// Amount of results that a solver computes. Each value includes the results of the values before it.
enum class Detail {
    /// Coefficient of restitution e and its error only; no history is kept.
    cor,
    /// Results of `cor`, and the peak force, times, and work of the hammer and on the rock. The computing
    /// time is hardly longer than for `cor`.
    summary,
    /// Results of `summary`, and the contact events with their times.
    events,
    /// Results of `events`, and the sums over the waves (finalMomentum, finalEnergy) that check the balances
    /// of momentum and energy independently of the impact force.
    ledger,
    /// Results of `ledger`, and the incident wave g(s) and impact force F(s) at the bit, from which every
    /// wave in the rod follows by delays.
    histories,
};

/// Reason why the computation of a blow ended.
enum class Outcome {
    /// It is proven that no contact of bit and rock can follow (theory §3.3, strings §8).
    rebounded,
    /// The end time that the user set was reached.
    endTime,
    /// The next blow began before it was proven that this blow is over; the numbers are not final.
    nextBlow,
    /// The work limit was reached, or rounding hid the order of events. `Impact::reason` says why; the
    /// numbers are invalid.
    notSolved,
};

/// Reason why a blow is not solved, for decisions by the program. `Impact::reason` holds the text for the
/// user.
enum class Hindrance {
    /// Any reason other than the work limit or too long histories, for example rounding or a stop request.
    other,
    /// The blow needs more computing work than the work limit permits.
    workLimit,
    /// The histories of the waves at the bit are too long to be kept. The blow may be solvable with less
    /// Detail, without them.
    histories,
};

/// Event at the contact of bit and rock.
enum class ContactEvent {
    /// The gap between bit and rock closes.
    contact,
    /// The impact force has a maximum on the primary loading curve, and unloading starts.
    unloading,
    /// The impact force reaches the primary loading curve again, after unloading and reloading.
    primaryLoading,
    /// The impact force reaches zero, and bit and rock separate.
    separation,
    /// The impact force on the loading curve passes a corner of the law, where the slope changes.
    corner,
};

/// Contact event of bit and rock, such as first contact or separation, with its time t/t0 since the start of
/// the blow. In the reference case (a rod that arrives as a rigid body) the time is counted from first
/// contact.
struct ImpactEvent {
    ContactEvent kind;
    double time;
    bool operator==(const ImpactEvent&) const = default;
};

/// Whole periods of free flight that were left out of the recording, because nothing happens in them. From
/// `start` on, the incident wave repeats with period 2τ for `duration`, a multiple of 2τ. Both are in units
/// of t0, with `start` counted from the arrival of the first wave at the bit.
struct PeriodSkip {
    double start;
    double duration;
    bool operator==(const PeriodSkip&) const = default;
};

class StringWaves;

/// Result of one blow on a uniform rod or drill string. Quantities have the units of the paper's section 5.1:
/// time t0, force F0 = I0/t0, impulse I0, displacement I0/Z (half of d0), energy I0²/(Z t0) = 2τ W0.
struct Impact {
    /// Time of an event that does not happen: NaN.
    static constexpr double never = std::numeric_limits<double>::quiet_NaN();

    /// Reason why the computation of the blow ended.
    Outcome outcome = Outcome::notSolved;
    /// Sentence that says why the blow is not solved; empty if it is solved.
    Message reason;
    /// Kind of reason why the blow is not solved; meaningless if it is solved.
    Hindrance hindrance = Hindrance::other;

    /// Returns whether the blow is solved, so that its numbers are valid.
    bool isSolved() const { return outcome != Outcome::notSolved; }

    /// Coefficient of restitution e. For a uniform rod, e = −pf/p0 = −1 + ∫F ds [paper (10)], with the
    /// momentum p0 that the hammer transfers and the final momentum pf of the rod. For a string it is −pf/∫P
    /// dt with the force P of the hammer face, and −1 + ∫F/∫P if joints or sections lose energy.
    double cor = 0;
    /// Upper bound of the absolute error of `cor`.
    double corError = 0;
    /// Impulse of the impact force over all contacts, ∫F ds, in units of I0; 1 + e for a uniform rod with the
    /// coefficient of restitution e.
    double impulse = 0;
    /// Factor by which later contacts may amplify the rounding errors of earlier ones (T38); ≥ 1.
    double growth = 1;

    // The members from here to rockWork require Detail::summary or more.
    /// Largest impact force between bit and rock, F/F0.
    double peakForce = 0;
    /// Time t/t0 of the first contact of bit and rock since the start of the blow.
    double firstContactTime = 0;
    /// Time t/t0 of the last separation of bit and rock since the start of the blow.
    double separationTime = 0;
    /// Sum of the durations of all contacts of bit and rock, in units of t0.
    double contactDuration = 0;
    /// Work of the hammer, W = ∫Fa va dt = ∫Fa (2g − Fa) dt [I0²/(Z t0)] (T19). For a hammer of sections, its
    /// initial kinetic energy E0.
    double hammerWork = 0;
    /// Impulse of the hammer force, ∫Fa dt [I0]. For a hammer of sections, its initial momentum p0.
    double hammerImpulse = 1;
    /// Work that stays in the rock, ∫F dU = A(Fm) − γFm²/(2β) [I0²/(Z t0)] (T42).
    double rockWork = 0;

    // The two members finalMomentum and finalEnergy require Detail::ledger or more; with less detail the
    // exact solver leaves NaN.
    /// Momentum of rod or string after the blow, in units of I0, positive towards the rock. It is the
    /// integral of the incident wave g over the last round trip, independent of `impulse`. For a uniform rod
    /// it equals −e, with the coefficient of restitution e.
    double finalMomentum = 0;
    /// Energy of rod or string after the blow [I0²/(Z t0)]: the integral ∫g² of the incident wave g over the
    /// last round trip.
    double finalEnergy = 0;

    // The members from here to efficiencyError keep their default values for a prescribed force on a uniform
    // rod.
    /// Momentum [I0] and energy [I0²/(Z t0)] that remain in the hammer after the blow.
    double hammerMomentum = 0, hammerEnergy = 0;
    /// Impulse that the hammer, or the prescribed force, has transferred to the string, in units of I0.
    double faceImpulse = 1;
    /// Elastic energy that remains in the contact stiffness of the hammer face [I0²/(Z t0)].
    double faceEnergy = 0;
    /// Time t/t0 at which hammer and string first separate; NaN if they do not.
    double faceSeparation = never;
    /// Energy lost in joints, and by attenuation along the sections [I0²/(Z t0)].
    double jointLoss = 0, rodLoss = 0;
    /// Momentum transferred to the surroundings by losses in joints and sections, in units of I0.
    double externalMomentum = 0;
    /// Stated error of efficiency() and of other energies, as a share of the hammer energy E0.
    double efficiencyError = 0;

    // The members from here to wavesDifference are used for drill strings only.
    /// Time t/t0 to which the blow was computed.
    double endTime = 0;
    /// Time t/t0 after which forces count as those of the residual waves after the blow; infinite if bit and
    /// rock do not separate.
    double endOfBlow = std::numeric_limits<double>::infinity();
    /// Largest forces of every section of hammer and string; empty unless requested and within the work
    /// limit.
    std::vector<SectionForces> sections;
    /// Stated relative error of the largest forces in `sections`.
    double forcesError = 0;
    /// Whether the largest forces were requested but left out because they need too much work.
    bool leftOutForces = false;
    /// Time t/t0 of the largest impact force; NaN if there is none.
    double peakTime = never;
    /// Time t/t0 to which the largest forces were searched: usually one round trip of the string after
    /// endOfBlow.
    double forcesEnd = 0;
    /// Energy reflected by each joint of two sections when a wave arrives from the hammer, as a share of
    /// hammerWork. Empty unless requested.
    std::vector<double> jointReflection;
    /// Waves in all sections over time; null unless requested and small enough to be kept.
    std::shared_ptr<const StringWaves> waves;
    /// Difference between this result and a coarser computation of the same blow, from which `waves` were
    /// copied. It is the larger of the differences in coefficient of restitution and in efficiency. Empty if
    /// `waves` were recorded in this computation.
    std::optional<double> wavesDifference;

    /// Replaces `waves` by the waves of a coarser computation of the same blow, if those of this one need too
    /// much memory. Sets wavesDifference to the difference between the two results.
    void takeWavesOf(const Impact& coarser) {
        waves = coarser.waves;
        wavesDifference =
            std::max(std::abs(coarser.cor - cor), std::abs(coarser.efficiency() - efficiency()));
    }

    /// Contact events of bit and rock in order of time; require Detail::events or more.
    std::vector<ImpactEvent> events;

    // The members from here to skips require Detail::histories; frontArrival and roundTrip only
    // Detail::summary.
    /// Time t/t0 at which the first wave reaches the bit, where s = 0: τ, or 0 in the reference case (a rod
    /// that arrives as a rigid body).
    double frontArrival = 0;
    /// Round-trip time 2τ of a wave in the rod, in units of t0.
    double roundTrip = 0;
    /// Incident wave at the bit, g(s) = −Np [F0], over recorded time, without the periods in `skips`. For a
    /// uniform rod, read it with incidentWave(), which adds these periods.
    PiecewisePolynomial incident;
    /// Impact force F(s) [F0], on the same polynomial pieces as `incident`. For a uniform rod, read it with
    /// impactForce(), which adds the periods in `skips`.
    PiecewisePolynomial force;
    /// Periods of free flight that the recording leaves out.
    std::vector<PeriodSkip> skips;

    // The members from here to sharedCell describe the work and the discretisation.
    /// Number of smooth pieces of the solution; for the lattice method, number of time steps.
    long pieces = 0;
    /// Number of separate contacts of bit and rock.
    int contacts = 0;
    /// Number of searches for contact events in pieces of the solution, because bounds did not exclude an
    /// event there; 0 for the lattice method.
    long searches = 0;
    /// Number of points evaluated in all searches for contact events.
    long samples = 0;
    /// Number of pieces of a first attempt in closed form that was discarded, because its error became too
    /// large before the end of the blow. They are not included in `pieces`.
    long abandoned = 0;
    /// Number of cells (time steps of waves) in which the largest forces were searched, because upper bounds
    /// of the force did not exclude them there.
    long cellsLookedInto = 0;
    /// Time step Δ (cell) of a method that divides time into equal steps, in units of t0; 0 for other
    /// methods.
    double cell = 0;
    /// Largest change of a section's round-trip time by rounding to whole cells (time steps), in units of t0.
    double rounding = 0;
    /// Time step (cell) that divides all round trips of the sections exactly, in units of t0. It was not
    /// used, because it takes too much work. 0 if there is no such time step, or if it was used.
    double sharedCell = 0;

    /// Returns whether rounding of round trips to whole numbers of cells (time steps) has changed the section
    /// lengths noticeably. Smaller changes are within the precision with which lengths are given.
    bool isRounded() const { return rounding > 1e-7; }
    /// Returns the efficiency: the share of the hammer work that stays in the rock, 0 … 1.
    double efficiency() const { return rockWork / hammerWork; }
    /// Returns the part of the hammer work that does not stay in the rock [I0²/(Z t0)]: the energy left in
    /// rod, hammer and hammer face, and the losses in joints and sections.
    double energyLeft() const { return finalEnergy + hammerEnergy + jointLoss + rodLoss + faceEnergy; }
    /// Returns the relative error of the energy balance. The reference is W, or 1e-3 I0²/(Z t0) if W is
    /// smaller: against rigid rock a hammer does almost no work, while rounding is relative to I0²/(Z t0).
    /// NaN without Detail::ledger.
    double energyResidual() const {
        return (hammerWork - rockWork - energyLeft()) / std::max(hammerWork, 1e-3);
    }
    /// Returns the error of the momentum balance as a share of the impulse of the hammer; NaN without
    /// Detail::ledger.
    double momentumResidual() const {
        return (hammerImpulse - impulse - hammerMomentum - finalMomentum - externalMomentum) / hammerImpulse;
    }
    /// Returns whether the energy balance of a computation with cells (time steps) is good enough; otherwise
    /// its result is refused. Cells that are too coarse for a wave lose energy. This loss was at most a share
    /// of 0.015 in 3000 test strings, while rounding added at most 3e-12.
    bool balances() const {
        constexpr double mostMade = 1e-6, mostLost = 0.05;
        return energyResidual() >= -mostMade && energyResidual() <= mostLost;
    }
    /// Returns the result of a blow that is not solved, with the reason for it.
    static Impact unsolved(Message reason, Hindrance hindrance = Hindrance::other) {
        Impact impact;
        impact.reason = std::move(reason);
        impact.hindrance = hindrance;
        return impact;
    }
    /// Returns whether the events are available, which requires Detail::events or more.
    bool hasEvents() const { return contacts == 0 || !events.empty(); }
    /// Returns whether the histories are available, which requires Detail::histories.
    bool hasHistories() const { return !incident.pieces().empty(); }
};

}  // namespace drillwave
