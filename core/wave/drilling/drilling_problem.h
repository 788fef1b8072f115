// SPDX-License-Identifier: GPL-3.0-or-later
// Problem of many blows on one rod or string under a feed force, in dimensionless form (drilling §1).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Machine body that rides on the feed and presses on the rear end of the string through a damper (D2).
struct MachineBody {
    /// Mass of the machine, M/(Zr t0); > 0.
    double mass = 1;
    /// Dashpot coefficient of the damper, ζ = c_d/Zr; ≥ 0.
    double damping = 0;
    /// Spring stiffness of the damper, κ = k_d t0/Zr; ≥ 0. Damping and stiffness may not both be 0.
    double stiffness = 0;
    bool operator==(const MachineBody&) const = default;
};

/// State of rod or string at the first blow.
enum class DrillingStart {
    /// Rod or string is at rest.
    rest,
    /// Rod or string moves towards the rock with half the reference velocity v0.
    bouncing,
};

/// One blow and all properties of the sequence of blows, in the dimensionless units of Problem (problem.h).
struct DrillingProblem {
    /// One blow of hammer, string and rock, which is repeated in the sequence. Joints and sections with a
    /// loss take momentum from waves. They return it to the string as a wave that decays over about one
    /// interval between blows (D5).
    Problem blow;
    /// Mean interval between blows, 1/(f t0); > 0.
    double interval = 1;
    /// Effective feed force Fe/F0.
    double feedForce = 0;
    /// Machine body between feed and rod. Without one, a constant force presses on the rod: the effective
    /// feed force Fe less the mean force of the blows.
    std::optional<MachineBody> machine;
    /// Wave loss η_j of every section per round trip, in addition to its attenuation; 0 ≤ η_j < 1 (drilling
    /// §3).
    std::vector<double> waveLosses;
    /// Whether every blow meets new rock, because the bit has turned.
    bool isFresh = true;
    /// Standard deviation of the intervals between blows, divided by their mean; ≥ 0. No interval deviates
    /// from the mean by more than three standard deviations.
    double intervalScatter = 0;
    /// Seed of the random numbers for the scatter of intervals.
    std::uint32_t seed = 1;
    /// State of rod or string at the first blow: at rest, or moving.
    DrillingStart start = DrillingStart::rest;
    bool operator==(const DrillingProblem&) const = default;
};

/// Returns whether waves in the rod or string lose energy.
bool losesWaves(const DrillingProblem& problem);

/// Results of one blow and of the interval up to the next one, in the dimensionless units of Problem
/// (problem.h). NaN: not available.
struct DrillingBlow {
    /// Time of the blow since the first one, in units of t0.
    double time = 0;
    /// Gap between the bit and the bottom of the crater at the blow, in units of I0/Zr; 0 in contact.
    double gap = 0;
    /// Momentum of rod or string divided by its mass at the blow, in units of F0/Zr, positive towards the
    /// rock.
    double velocity = 0;
    /// Impulse on the rock, in units of I0. This member and all later ones describe the interval from this
    /// blow to the next one.
    double rockImpulse = 0;
    /// Increase of the residual penetration between this blow and the next one, in units of I0/Zr.
    double penetration = 0;
    /// Depth of the hole that all blows up to and including this one have drilled, in units of I0/Zr.
    double holeDepth = 0;
    /// Largest impact force between this blow and the next one, in units of F0.
    double peakForce = 0;
    /// Number of contacts of bit and rock that began between this blow and the next one.
    double contacts = 0;
    /// Total duration of contact of bit and rock between this blow and the next one, in units of t0.
    double contactTime = 0;
    /// Largest force D of the damper on the rear end between this blow and the next one, in units of F0.
    double damperPeak = 0;
    /// Impulse J that the hammer transfers to the string in this blow, in units of I0; 1 for a prescribed
    /// force.
    double faceImpulse = 0;
    /// Velocity of the hammer after this blow, in units of F0/Zr, positive away from the rock; NaN for a
    /// prescribed force.
    double hammerRebound = 0;
    /// Position of the rear end relative to the machine at this blow, x_r − x_b, in units of I0/Zr; NaN
    /// without a machine.
    double shankOffset = 0;
    bool operator==(const DrillingBlow&) const = default;
};

/// Energy balance of all blows so far, in units of F0² t0/Zr. The supplied energy, `hammer` + `feed`, equals
/// the sum of all other members.
struct DrillingLedger {
    /// Work ∫Fa v_r dt of the prescribed force, or the energy that all hammers together have transferred.
    double hammer = 0;
    /// Work ∫S v_b dt of the mean feed force S on the machine body; ∫S v_r dt on the rear end if there is no
    /// machine.
    double feed = 0;
    /// Work on the rock ∫F dU, less the elastic energy lost when compressed rock was replaced by new rock
    /// (`faces`).
    double rock = 0;
    /// Work done on the damper between machine and rear end, ∫D (v_b − v_r) dt, including the energy stored
    /// in its spring.
    double damper = 0;
    /// Energy that waves have lost in sections and joints.
    double waves = 0;
    /// Elastic energy of compressed rock that was lost because the bit turned to new rock.
    double faces = 0;
    /// Increase of the energy in machine, waves and lumped masses since the first blow.
    double stored = 0;
    /// Returns the error of the energy balance, in units of F0² t0/Zr; 0 if the balance is exact.
    double residual() const { return hammer + feed - rock - damper - waves - faces - stored; }
    bool operator==(const DrillingLedger&) const = default;
};

// Time steps (cells) for many blows: the start of every blow falls between two cells (drilling §6).

/// Division of time into cells (time steps) for a sequence of blows.
struct DrillingGrid {
    /// Size Δ of a cell (time step), in units of t0.
    double cell = 0;
    /// Round trip 2T of each section in cells (time steps); it need not be a whole number.
    std::vector<double> roundTrips;
    /// Division of cells (time steps) into parts, if a jump of the prescribed force lies inside a cell;
    /// otherwise one part.
    CellCuts cuts;
    /// Number of cells (time steps) in the mean interval between blows.
    long cellsOfInterval = 1;
    /// Whether hammer and string count as separated as soon as the contact force is zero; otherwise only
    /// after a whole time step (cell) without contact. It is false if the round trips of waves are not whole
    /// numbers of time steps. The polynomial that represents a wave front then oscillates, and may open a gap
    /// that does not exist.
    bool releasesAtOnce = true;

    /// Returns the mean interval between blows, rounded to a whole number of cells (time steps), in units of
    /// t0.
    double interval() const { return static_cast<double>(cellsOfInterval) * cell; }
    /// Returns the relative change of the blow frequency that results if the interval between blows is
    /// rounded to whole cells (time steps).
    double rounding(const DrillingProblem& problem) const { return problem.interval / interval() - 1; }
    /// Sets roundTrips for these sections, in cells (time steps); the size of the cells does not change.
    void setSections(const std::vector<UniformSection>& sections);
    /// Returns whether the round trips of all sections are whole numbers of cells (time steps).
    bool hasWholeTrips() const;
    /// Returns the index of the first section whose round trip is shorter than a cell (time step); the
    /// computation refuses such sections. Returns nullopt if there is none.
    std::optional<std::size_t> shortSection() const;
    /// Returns the estimated computing work of one blow: the number of time steps (cells or their parts)
    /// times the number of nodes (ends of sections).
    double work(const DrillingProblem& problem) const {
        return static_cast<double>(cellsOfInterval) * static_cast<double>(cuts.count()) *
               static_cast<double>(problem.blow.sections.size() + 1);
    }
};

/// Returns a division of time into equal cells (time steps), at least `cellsPerDuration` of them per t0. The
/// interval between blows is rounded to a whole number of cells. Short sections need smaller cells, so that
/// their round trip has at least one cell; shortSection() finds a section that is too short. All round trips
/// are whole numbers of cells if they have a common divisor of at least t0/(4·`cellsPerDuration`).
DrillingGrid drillingGridOf(const DrillingProblem& problem, int cellsPerDuration);
/// Returns a second division of time, to estimate the error that the cells (time steps) cause. Its cells are
/// twice as large as those of drillingGridOf(), or half as large if no suitable larger cells exist. The
/// interval between blows is the same, so results differ because of the cells only. The hammer always
/// separates at once; the difference therefore includes the effect of separations shorter than a cell.
DrillingGrid comparedDrillingGridOf(const DrillingProblem& problem, int cellsPerDuration);

}  // namespace drillwave
