// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows on one rod or string under a feed, dimensionless (drilling §1).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/wave/problem.h"

namespace drillwave {

/// What rides on the feed and presses on the rear end (D2).
struct MachineBody {
    double mass = 1;       ///< M/(Zr t0); > 0
    double damping = 0;    ///< ζ = c_d/Zr; ≥ 0
    double stiffness = 0;  ///< κ = k_d t0/Zr; ≥ 0. Not both are 0
    bool operator==(const MachineBody&) const = default;
};

/// How waves and motions begin.
enum class DrillingStart {
    rest,      ///< nothing moves
    bouncing,  ///< rod or string moves with v0/2 towards the rock
};

/// What is marched, in the units of Problem: the blow, and what lives on between blows.
struct DrillingProblem {
    Problem blow;          ///< what joints and sections take from a wave comes back (D5)
    double interval = 1;   ///< 1/(f t0)
    double feedForce = 0;  ///< Fe/F0
    std::optional<MachineBody>
        machine;                     ///< nothing: a constant force, Fe less the mean reaction of the blows
    std::vector<double> waveLosses;  ///< η_j of every section beside that, 0 ≤ η_j < 1 (drilling §3)
    bool isFresh = true;             ///< new rock for every blow
    double intervalScatter = 0;      ///< normal deviation of an interval over its mean, cut at three of them
    std::uint32_t seed = 1;          ///< of that
    DrillingStart start = DrillingStart::rest;
    bool operator==(const DrillingProblem&) const = default;
};

/// Returns whether waves fade in the rod or string.
bool losesWaves(const DrillingProblem& problem);

/// What one blow and the cycle behind it came to, in the units of Problem. What is not there is not a number.
struct DrillingBlow {
    double time = 0;           ///< of the blow
    double gap = 0;            ///< between bit and bottom of the crater at that time; 0 in contact
    double velocity = 0;       ///< momentum of rod or string over its mass at that time
    double rockImpulse = 0;    ///< of the cycle, like all that follows
    double penetration = 0;    ///< what stays
    double holeDepth = 0;      ///< with all cycles before
    double peakForce = 0;      ///< of the rock
    double contacts = 0;       ///< that began
    double contactTime = 0;    ///< sum
    double damperPeak = 0;     ///< largest D
    double faceImpulse = 0;    ///< J, of a rod I0
    double hammerRebound = 0;  ///< velocity of the hammer at the end, backwards positive
    double shankOffset = 0;    ///< x_r − x_b at the blow
    bool operator==(const DrillingBlow&) const = default;
};

/// Where the energy of all cycles went [F0² t0/Zr]: hammer + feed = the others.
struct DrillingLedger {
    double hammer = 0;  ///< ∫Fa v_r dt, or what the pistons brought less what they took away
    double feed = 0;    ///< ∫S v_b dt; of a constant force ∫S v_r dt
    double rock = 0;    ///< ∫F dU, less what went with the faces
    double damper = 0;  ///< ∫D (v_b − v_r) dt
    double waves = 0;   ///< that the waves lost
    double faces = 0;   ///< that went with the rock that was left behind
    double stored = 0;  ///< change of what machine, waves and masses hold
    double residual() const { return hammer + feed - rock - damper - waves - faces - stored; }
    bool operator==(const DrillingLedger&) const = default;
};

}  // namespace drillwave
