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

/// Amount of results from a solver; each level includes those before it.
enum class Detail {
    cor,        ///< e and its error only: no history kept
    summary,    ///< peak force, times, work of the hammer and on the rock: hardly more work than only e
    events,     ///< also the events and their times
    ledger,     ///< sums over the waves that balance momentum and energy independently
    histories,  ///< g(s) and F(s), from which every wave field follows by delays
};

/// Reason why the solution ended.
enum class Outcome {
    rebounded,  ///< proven: no contact can follow (theory §3; strings §8)
    endTime,    ///< followed to the end time that was set
    nextBlow,   ///< followed to the next blow without proof that it is over: not final
    notSolved,  ///< work limit reached or undecidable; `reason` says why, do not use the numbers
};

/// Reason why a blow is not solved, as far as a program may do something about it; for people see
/// `Impact::reason`.
enum class Hindrance {
    other,      ///< of the blow, the method or the numbers
    workLimit,  ///< more wave pieces than were permitted
    histories,  ///< more than can be kept: with less detail it may be solved
};

/// Events at the bit–rock interface.
enum class ContactEvent {
    contact,         ///< the gap closes
    unloading,       ///< the force leaves the primary line at a maximum
    primaryLoading,  ///< the force returns to the primary line
    separation,      ///< the force reaches zero
    corner,          ///< the force on the loading curve passes a corner of the law
};

/// An event and its global time t/t0 (for the reference case from first contact).
struct ImpactEvent {
    ContactEvent kind;
    double time;
    bool operator==(const ImpactEvent&) const = default;
};

/// Periods of free flight that were not recorded because nothing happens in them: from `start` on, the
/// incident wave repeats itself for `duration` (a multiple of 2τ).
struct PeriodSkip {
    double start;
    double duration;
    bool operator==(const PeriodSkip&) const = default;
};

class StringWaves;

/// Result of one blow of any drive on any chain. Units of section 5.1 of the paper: time t0, force F0 =
/// I0/t0, impulse I0, displacement I0/Z (half of d0), energy I0²/(Z t0) = 2τ W0.
struct Impact {
    static constexpr double never = std::numeric_limits<double>::quiet_NaN();

    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< one sentence when not solved
    Hindrance hindrance = Hindrance::other;

    bool isSolved() const { return outcome != Outcome::notSolved; }

    double cor = 0;  ///< e = −pf/p0 = −1 + ∫F [paper (10)]; of a string −pf/∫P, with losses −1 + ∫F/∫P
    double corError = 0;  ///< bound on |cor − exact|
    double impulse = 0;   ///< ∫F ds [I0]; 1 + e of a uniform rod
    double growth = 1;    ///< by how much later contacts may multiply the rounding of earlier ones (T38)

    // Detail::summary and above
    double peakForce = 0;         ///< largest F/F0
    double firstContactTime = 0;  ///< global time; frontArrival + s
    double separationTime = 0;    ///< global time of the last separation
    double contactDuration = 0;   ///< summed over contacts
    /// W = ∫Fa va dt = ∫Fa (2g − Fa) dt [I0²/(Z t0)] (T19); E0 of a hammer that is followed.
    double hammerWork = 0;
    double hammerImpulse = 1;  ///< ∫Fa dt [I0]; p0 of a hammer that is followed
    double rockWork = 0;       ///< ∫F dU = A(Fm) − γFm²/(2β) [I0²/(Z t0)]: left in the law (T6)

    // Detail::ledger and above; NaN from the exact solver with less
    double finalMomentum = 0;  ///< of rod or string, towards the rock, independent of `impulse`: ∫g; −e
    double finalEnergy = 0;    ///< of rod or string [I0²/(Z t0)]: ∫g² over the last period

    // Absent from a uniform rod under a force: followed hammer, joints and losses
    double hammerMomentum = 0, hammerEnergy = 0;  ///< left in the hammer [I0], [I0²/(Z t0)]
    double faceImpulse = 1;                       ///< transferred from hammer or force to the string [I0]
    double faceEnergy = 0;                        ///< in the stiffness of the faces [I0²/(Z t0)]
    double faceSeparation = never;                ///< when hammer and string first separate
    double jointLoss = 0, rodLoss = 0;            ///< energy lost in joints and on the way [I0²/(Z t0)]
    double externalMomentum = 0;                  ///< lost in joints and rods [I0]
    double efficiencyError = 0;                   ///< stated error of efficiency() and of other shares of E0

    // Drill strings only
    double endTime = 0;  ///< time to which it was followed
    /// Time when the blow is over for the forces of the sections: infinite if bit and rock do not separate.
    double endOfBlow = std::numeric_limits<double>::infinity();
    std::vector<SectionForces> sections;  ///< where wanted, and not too much work
    double forcesError = 0;               ///< stated error of the largest of them, as a share of it
    bool leftOutForces = false;           ///< they were wanted and too much work
    double peakTime = never;              ///< of peakForce
    double forcesEnd = 0;  ///< until when they count: a round trip of the string after endOfBlow, or less
    std::vector<double> jointReflection;  ///< share of hammerWork per joint of two sections, where wanted
    std::shared_ptr<const StringWaves> waves;  ///< where wanted, and not more than can be kept
    /// Greatest difference of e and efficiency of the coarser string that `waves` are from, where those of
    /// this one are too many to be kept.
    std::optional<double> wavesDifference;

    /// Takes the waves of another run, of a coarser string.
    void takeWavesOf(const Impact& coarser) {
        waves = coarser.waves;
        wavesDifference =
            std::max(std::abs(coarser.cor - cor), std::abs(coarser.efficiency() - efficiency()));
    }

    std::vector<ImpactEvent> events;  ///< Detail::events and above

    // Detail::histories
    double frontArrival = 0;        ///< global time of s = 0: τ, or 0 for the reference case
    double roundTrip = 0;           ///< 2τ
    PiecewisePolynomial incident;   ///< g(s) = −Np at the front end; use incidentWave() to read it of a rod
    PiecewisePolynomial force;      ///< F(s) on the same pieces; for a rod use impactForce()
    std::vector<PeriodSkip> skips;  ///< where the recorded time leaves out periods of free flight

    // How much work it was
    long pieces = 0;     ///< smooth pieces solved (steps for the lattice)
    int contacts = 0;    ///< separate contacts
    long searches = 0;   ///< for events that bounds could not exclude; none by the lattice
    long samples = 0;    ///< points at which these searches looked
    long abandoned = 0;  ///< pieces solved in a representation that did not reach its end, besides `pieces`
    long cellsLookedInto = 0;  ///< for the largest forces: those that bounds could not exclude
    double cell = 0;           ///< Δ of a lattice of cells [t0]
    double rounding = 0;       ///< of the round trips on it, largest [t0]
    double sharedCell = 0;  ///< where they were rounded although they share one: it takes too much work [t0]

    /// Returns whether lengths differ by more than they are given to.
    bool isRounded() const { return rounding > 1e-7; }
    double efficiency() const { return rockWork / hammerWork; }
    /// Returns the hammer work that is left anywhere but in the rock [I0²/(Z t0)].
    double energyLeft() const { return finalEnergy + hammerEnergy + jointLoss + rodLoss + faceEnergy; }
    /// Returns the error of the energy balance, as a share of W, or of 1e-3 I0²/(Z t0) where that is larger:
    /// a hammer that pushes a rod against rigid rock does next to no work, and the sums round at I0²/(Z t0).
    /// NaN without Detail::ledger.
    double energyResidual() const {
        return (hammerWork - rockWork - energyLeft()) / std::max(hammerWork, 1e-3);
    }
    /// Returns the error of the momentum balance, as a share of the impulse of the hammer.
    double momentumResidual() const {
        return (hammerImpulse - impulse - hammerMomentum - finalMomentum - externalMomentum) / hammerImpulse;
    }
    /// Whether a run of cells can be a result at all: they lose energy where they do not resolve a wave,
    /// 0.015 at most of 3000 strings with a hundredth of the work that is permitted; they make none, 3e-12 at
    /// most by rounding.
    bool balances() const {
        constexpr double mostMade = 1e-6, mostLost = 0.05;
        return energyResidual() >= -mostMade && energyResidual() <= mostLost;
    }
    /// The blow is not solved.
    static Impact unsolved(Message reason, Hindrance hindrance = Hindrance::other) {
        Impact impact;
        impact.reason = std::move(reason);
        impact.hindrance = hindrance;
        return impact;
    }
    bool hasEvents() const { return contacts == 0 || !events.empty(); }  ///< of Detail::events or above
    bool hasHistories() const { return !incident.pieces().empty(); }     ///< of Detail::histories
};

}  // namespace drillwave
