// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows on one rod or string under a feed, dimensionless (drilling §1).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Drill body that rides on the feed and presses on the rear end (D2).
struct MachineBody {
    double mass = 1;       ///< M/(Zr t0); > 0
    double damping = 0;    ///< ζ = c_d/Zr; ≥ 0
    double stiffness = 0;  ///< κ = k_d t0/Zr; ≥ 0. Not both are 0
    bool operator==(const MachineBody&) const = default;
};

/// State at the beginning.
enum class DrillingStart {
    rest,      ///< nothing moves
    bouncing,  ///< rod or string moves with v0/2 towards the rock
};

/// Blow and everything that stays between blows, in the units of Problem.
struct DrillingProblem {
    Problem blow;          ///< joints and sections return what they take from a wave (D5)
    double interval = 1;   ///< 1/(f t0)
    double feedForce = 0;  ///< Fe/F0
    std::optional<MachineBody>
        machine;                     ///< nothing: a constant force, Fe less the mean reaction of the blows
    std::vector<double> waveLosses;  ///< η_j of every section in addition, 0 ≤ η_j < 1 (drilling §3)
    bool isFresh = true;             ///< new rock for every blow
    double intervalScatter = 0;      ///< normal deviation of an interval over its mean, cut at three of these
    std::uint32_t seed = 1;          ///< of the scatter
    DrillingStart start = DrillingStart::rest;
    bool operator==(const DrillingProblem&) const = default;
};

/// Returns whether waves fade in the rod or string.
bool losesWaves(const DrillingProblem& problem);

/// Results of one blow and the cycle after it, in the units of Problem. NaN: not available.
struct DrillingBlow {
    double time = 0;           ///< of the blow
    double gap = 0;            ///< between bit and bottom of the crater at that time; 0 in contact
    double velocity = 0;       ///< momentum of rod or string over its mass at that time
    double rockImpulse = 0;    ///< of the cycle, as are all below
    double penetration = 0;    ///< left in the rock
    double holeDepth = 0;      ///< sum over all cycles so far
    double peakForce = 0;      ///< of the rock
    double contacts = 0;       ///< contacts begun
    double contactTime = 0;    ///< sum
    double damperPeak = 0;     ///< largest D
    double faceImpulse = 0;    ///< J, of a rod I0
    double hammerRebound = 0;  ///< velocity of the hammer at the end, backwards positive
    double shankOffset = 0;    ///< x_r − x_b at the blow
    bool operator==(const DrillingBlow&) const = default;
};

/// Balance of the energy of all cycles [F0² t0/Zr]: hammer + feed = the others.
struct DrillingLedger {
    double hammer = 0;  ///< ∫Fa v_r dt, or the energy brought by the pistons less what they took away
    double feed = 0;    ///< ∫S v_b dt; of a constant force ∫S v_r dt
    double rock = 0;    ///< ∫F dU, less the work lost with replaced rock
    double damper = 0;  ///< ∫D (v_b − v_r) dt
    double waves = 0;   ///< that the waves lost
    double faces = 0;   ///< lost with replaced rock
    double stored = 0;  ///< change in machine, waves and masses
    double residual() const { return hammer + feed - rock - damper - waves - faces - stored; }
    bool operator==(const DrillingLedger&) const = default;
};

// The cells of many blows: the fronts of all of them lie between cells (drilling §6).

struct DrillingGrid {
    double cell = 0;                 ///< Δ [t0]
    std::vector<double> roundTrips;  ///< 2 T of each section in cells; need not be whole
    CellCuts cuts;                   ///< where a front of a force lies inside every cell
    long cellsOfInterval = 1;
    /// Whether hammer and string are separate as soon as they part. If round trips are not whole cells, the
    /// cubic that represents a front swings around it and may open a false gap: then they must be apart for a
    /// cell.
    bool releasesAtOnce = true;

    double interval() const { return static_cast<double>(cellsOfInterval) * cell; }
    /// Returns the change of the frequency by rounding, as a share of it.
    double rounding(const DrillingProblem& problem) const { return problem.interval / interval() - 1; }
    /// Sets the round trips of other sections in the same cells.
    void setSections(const std::vector<UniformSection>& sections);
    bool hasWholeTrips() const;
    /// Returns the first section whose round trip is shorter than a cell, which no march accepts.
    std::optional<std::size_t> shortSection() const;
    /// Returns the estimated work of a blow [cells × nodes].
    double work(const DrillingProblem& problem) const {
        return static_cast<double>(cellsOfInterval) * static_cast<double>(cuts.count()) *
               static_cast<double>(problem.blow.sections.size() + 1);
    }
};

/// Returns a grid of at least that many cells per t0, and one in every round trip if up to eight times as
/// many do. Intervals become whole cells; so do round trips that share a cell not much smaller than wanted.
DrillingGrid drillingGridOf(const DrillingProblem& problem, int cellsPerDuration);
/// Returns the same grid with cells twice as large, or half as large where the round trips of a string share
/// no larger ones. The interval is the same, so differences are due to the cells only. The hammer always
/// separates at once: a separation shorter than a cell, which the cells decide, is part of the difference.
DrillingGrid comparedDrillingGridOf(const DrillingProblem& problem, int cellsPerDuration);

}  // namespace drillwave
