// SPDX-License-Identifier: GPL-3.0-or-later
// Blow: a scenario, the method, the solution and everything derived from it.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/blow/impact_summary.h"
#include "core/blow/method.h"
#include "core/blow/string_blow.h"
#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/text/message.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Number of one blow in a sequence under a feed, and the largest force that its rock has felt in earlier
/// blows.
struct MarchedStart {
    long number = 1;  ///< Number of the blow in the sequence, from 1.
    /// Largest force that the rock under the bit has felt before this blow, in units of F0.
    double rememberedForce = 0;
};

/// Blow with all values that are shown, written or reported about it.
struct Blow {
    /// Scenario (all input values) of the blow.
    Scenario scenario;
    /// Method by which the blow was solved, with its settings.
    MethodChoice method;
    /// Dimensionless groups β, γ, τ, δ of the scenario.
    Groups groups;
    /// Factors from dimensionless values to SI; all 1 for a dimensionless scenario.
    Scales scales;
    /// Scenario in dimensionless form, as it was solved.
    Problem problem;
    /// Result of the solver; if the blow is not solved, impact.reason says why.
    Impact impact;
    /// Numbers of the result, dimensionless. They and `feed` are invalid if the blow is not solved.
    ImpactSummary summary;
    /// Estimate of the feed force that the blow requires; nothing if thrustProblem() gives a reason, such as
    /// a missing blow frequency. Estimates that need blows with all other gaps between bit and rock are left
    /// to a study (core/study/thrust).
    std::optional<FeedEstimate> feed;
    /// Alerts of the scenario, followed by those of the result.
    std::vector<Alert> alerts;
    /// Computing time of the solver only, in seconds.
    double runTime = 0;
    /// Number of the blow and state of its rock if it belongs to a sequence of blows under a feed; otherwise
    /// empty. Such a blow has no `feed`, and its `summary` has only the values that the window shows, such as
    /// forces and contact times, but no rebound.
    std::optional<MarchedStart> marched = {};

    /// Returns whether the blow is solved, so that its numbers are valid.
    bool isSolved() const { return impact.isSolved(); }
    /// Returns whether the scenario is a drill string, which is solved in time steps (polynomial cells).
    bool isOfString() const { return isString(scenario); }
    /// Returns the energy to which all energy shares of the blow refer, in units of W0 = m v0²/2. It is the
    /// work of a prescribed force, or 1 for a hammer, whose energy is W0.
    double drivenEnergy() const { return drillwave::drivenEnergy(summary, scenario); }
    /// Returns the margin of the feed force, (effective feed force)/(largest of the four required feed
    /// forces) − 1; nullopt if one of these forces is unknown.
    std::optional<double> thrustMargin() const { return feed ? feed->margin() : std::nullopt; }
};

/// Choice whether solveBlow() computes the largest forces and stresses of a uniform rod. They require the
/// histories of the waves.
enum class Stresses {
    /// Largest forces only if the rod has a strength, so that alerts compare them with it.
    asNeeded,
    /// Largest forces and stresses whenever they can be computed.
    wanted,
};

/// Solves the blow of a scenario and returns it, with at least the results of `detail`. If the scenario is
/// invalid, the blow is unsolved and contains the reason. A stop request also leaves it unsolved. Stresses of
/// a uniform rod need all waves, which may be too many to be kept. Then the exact method evaluates the waves
/// during the computation, and the lattice method omits the stresses. With Detail::histories, such a blow is
/// unsolved.
Blow solveBlow(const Scenario& scenario, const MethodChoice& method, Detail detail,
               const std::stop_token& stop = {}, Stresses stresses = Stresses::asNeeded);

/// Solves the blow of a scenario with an existing solver, whose memory is reused, and returns the blow.
/// `ofString` is the accuracy for drill strings. The other arguments are those of solveBlow() without a
/// solver.
Blow solveBlow(const Scenario& scenario, const MethodChoice& method, Detail detail,
               const std::stop_token& stop, Stresses stresses, MethodSolver& solver,
               NetworkAccuracy ofString = NetworkAccuracy::sure);

// Names of the method for reports, records and remarks

/// Returns the name of the method in JSON: "polynomial_cells" for a drill string, whatever `method` is;
/// otherwise that of `method`.
std::string_view methodKey(const Scenario& scenario, Method method);

/// Names of the method that solved a blow, for several uses.
struct SolverWords {
    /// Name of the method in JSON, such as "polynomial_cells".
    std::string key;
    /// Name of the method for the user, such as "lattice of 1000 segments".
    Message name;
    /// Method and settings as a part of a sentence, such as "method lattice, 1000 segments" or "polynomial
    /// cells".
    Message asked;
    /// Name of the method with its settings in the comment lines at the start of a file, such as "method
    /// polynomial_cells". remarksOf() reads it again.
    std::string remark;
    /// Number of computed steps or wave pieces (Impact::pieces), as text with a noun, such as "11 cells" or
    /// "1000 steps".
    Message pieces;
};
/// Returns the names of the method that solved the blow, to be written into results and reports.
SolverWords solverWords(const Blow& blow);

}  // namespace drillwave
