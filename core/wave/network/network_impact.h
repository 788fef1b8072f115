// SPDX-License-Identifier: GPL-3.0-or-later
// One blow on a drill string, solved.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/wave/impact.h"
#include "core/wave/network/string_waves.h"

namespace drillwave {

/// What ended the solution.
enum class NetworkEnd {
    proven,    ///< neither rock nor hammer can be met again (strings §8)
    endTime,   ///< followed to the time that was asked for
    nextBlow,  ///< followed to the next blow, and not proven to be over: not final
    notSolved  ///< `reason` says why, numbers are not to be used
};

/// The largest force of one sign in a section, and where.
struct SectionPeak {
    double force = 0;  ///< [F0], of either sign ≥ 0
    double place = 0;  ///< ξ in the section, 0 at its rear end … 1
    double time = 0;   ///< [t0]
};

/// Compression and tension of one section of hammer or string, as RodForces has those of a rod: while the
/// blow lasts, to one transit of the string after the last separation of bit and rock, and later: at least
/// while waves run to and fro once in the string, unless an end time or the next blow come before.
struct SectionForces {
    SectionPeak compression;
    SectionPeak tension;
    SectionPeak compressionAfter;
    SectionPeak tensionAfter;
};

/// Where the energy of the hammer went, in E0; the sum is 1 but for `energyResidual`.
struct NetworkLedger {
    double rock = 0;    ///< work on the rock
    double hammer = 0;  ///< still in the hammer
    double string = 0;  ///< in the string with its masses
    double joints = 0;  ///< lost in joints
    double rods = 0;    ///< lost on the way through sections
    double face = 0;    ///< in the stiffness of the faces
};

/// Result of one blow. Units of Problem.
struct NetworkImpact {
    NetworkEnd end = NetworkEnd::notSolved;
    std::string reason;  ///< one sentence when not solved
    Hindrance hindrance = Hindrance::other;
    double endTime = 0;  ///< the time of all that follows

    double hammerEnergy = 0;     ///< E0
    double hammerMomentum = 0;   ///< p0
    NetworkLedger energy;        ///< [E0]
    double energyResidual = 0;   ///< 1 − the sum of the ledger
    double efficiencyError = 0;  ///< stated error of energy.rock
    double corError = 0;         ///< stated error of −stringMomentum/faceImpulse

    double rockImpulse = 0, pistonMomentum = 0, stringMomentum = 0;  ///< towards the rock
    double externalMomentum = 0;                                     ///< given away in joints and rods
    double momentumResidual = 0;                                     ///< what the four leave of p0 [p0]
    double hammerMass = 0;                                           ///< [Zr t0]

    double peakForce = 0, peakTime = 0;  ///< of the rock
    double largestPenetration = 0, residualPenetration = 0;
    double firstContact = -1, lastSeparation = -1;  ///< of bit and rock; negative: never
    double contactDuration = 0;
    int contacts = 0;

    /// When the blow is over for the forces of the sections: infinite where bit and rock do not part.
    double endOfBlow = std::numeric_limits<double>::infinity();

    double faceImpulse = 0;
    double faceSeparation = -1;  ///< the first; negative: never

    std::vector<ImpactEvent> events;      ///< at the rock
    std::vector<SectionForces> sections;  ///< where wanted, and not too much work
    bool leftOutForces = false;           ///< they were wanted and too much work
    double forcesEnd =
        0;  ///< to when they and the waves were followed: endTime, or a round trip after the blow
    std::vector<double> jointReflection;       ///< [E0] per joint of two sections, where wanted
    std::shared_ptr<const StringWaves> waves;  ///< where wanted, and not more than can be kept

    long cells = 0;            ///< cells times nodes: the work
    long cellsLookedInto = 0;  ///< for the largest forces: those that bounds did not rule out
    double cell = 0;           ///< Δ [t0]
    double rounding = 0;       ///< of the round trips, largest [t0]
    double sharedCell = 0;  ///< where they were rounded although they share one: it takes too much work [t0]

    /// Whether it can be a result at all. Cells lose energy where they do not resolve a wave, 0.015 at most
    /// of 3000 strings with a hundredth of the work that is permitted; they make none, 3e-12 at most by
    /// rounding.
    bool balances() const {
        constexpr double mostMade = 1e-6, mostLost = 0.05;
        return energyResidual >= -mostMade && energyResidual <= mostLost;
    }
};

}  // namespace drillwave
