// SPDX-License-Identifier: GPL-3.0-or-later
// One blow, solved: the common result of every solver, all quantities dimensionless.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/numeric/piecewise.h"

namespace drillwave {

/// How much a solver is asked for; each level includes those before it.
enum class Detail {
    cor,        ///< e and its error only: no history kept
    summary,    ///< peak force, times, work of the hammer and on the rock: hardly more work than e alone
    events,     ///< what happened when, too
    ledger,     ///< sums over the waves that balance momentum and energy independently
    histories,  ///< g(s) and F(s), from which every wave field follows by delays
};

/// What ended the solution.
enum class Outcome {
    rebounded,  ///< proven: no contact can follow (theory §3)
    notSolved,  ///< work limit reached or undecidable; `reason` says why, numbers are not to be used
};

/// Why a blow is not solved, as far as a program may do something about it; `Impact::reason` says it to
/// people.
enum class Hindrance {
    other,      ///< of the blow, the method or the numbers
    workLimit,  ///< more wave pieces than were permitted
    histories,  ///< more than can be kept: with less detail it may be solved
};

/// What happened at the bit–rock interface.
enum class ContactEvent {
    contact,         ///< the gap closes
    unloading,       ///< the force leaves the primary line at a maximum
    primaryLoading,  ///< the force returns to the primary line
    separation,      ///< the force reaches zero
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

/// Result of one blow. Units of section 5.1 of the paper: time t0, force F0 = I0/t0, impulse I0, displacement
/// I0/Z (half of d0), energy I0²/(Z t0) = 2τ W0.
struct Impact {
    Outcome outcome = Outcome::notSolved;
    std::string reason;  ///< one sentence when not solved
    Hindrance hindrance = Hindrance::other;

    double cor = 0;       ///< e = −pf/p0 = −1 + ∫F [paper (10)]
    double corError = 0;  ///< bound on |cor − exact|
    double impulse = 0;   ///< ∫F ds = 1 + e
    double growth = 1;    ///< by how much later contacts may multiply the rounding of earlier ones (T38)

    // Detail::summary and above
    double peakForce = 0;         ///< largest F/F0
    double firstContactTime = 0;  ///< global time; frontArrival + s
    double separationTime = 0;    ///< global time of the last separation
    double contactDuration = 0;   ///< summed over contacts
    double hammerWork = 0;        ///< W = ∫Fa va dt = ∫Fa (2g − Fa) dt [I0²/(Z t0)] (T19)
    double rockWork = 0;  ///< ∫F dU = (1 − γ) Fm²/(2β) [I0²/(Z t0)]: what the law has kept (T6)

    // Detail::ledger and above; of the exact solver not a number below
    double finalMomentum = 0;  ///< ∫g over the last period, independent of `impulse`; −e
    double finalEnergy = 0;    ///< ∫g² over the last period [I0²/(Z t0)]

    std::vector<ImpactEvent> events;  ///< Detail::events and above

    // Detail::histories
    double frontArrival = 0;        ///< global time of s = 0: τ, or 0 for the reference case
    double roundTrip = 0;           ///< 2τ
    PiecewisePolynomial incident;   ///< g(s) = −Np at the front end; use incidentWave() to read it
    PiecewisePolynomial force;      ///< F(s) on the same pieces; use impactForce() to read it
    std::vector<PeriodSkip> skips;  ///< where the recorded time leaves out periods of free flight

    // How much work it was
    long pieces = 0;     ///< smooth pieces solved (steps for the lattice)
    int contacts = 0;    ///< separate contacts
    long searches = 0;   ///< for events: those that bounds alone did not answer; none by the lattice
    long samples = 0;    ///< points at which these searches looked
    long abandoned = 0;  ///< pieces solved in a representation that did not come to its end, besides `pieces`

    /// What the balance of the energies leaves, of W, or of 1e-3 I0²/(Z t0) where that is larger: a hammer
    /// that pushes a rod against rigid rock does next to no work, and the sums round at I0²/(Z t0). Not a
    /// number without Detail::ledger.
    double energyResidual() const {
        return (hammerWork - rockWork - finalEnergy) / std::max(hammerWork, 1e-3);
    }
    bool hasEvents() const { return contacts == 0 || !events.empty(); }  ///< of Detail::events or above
    bool hasHistories() const { return !incident.pieces().empty(); }     ///< of Detail::histories
};

}  // namespace drillwave
