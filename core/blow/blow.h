// SPDX-License-Identifier: GPL-3.0-or-later
// A blow: a scenario, how it was solved, and all that follows from its solution.
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

/// Start of one of many blows under a feed, with the waves and motions that earlier blows have left.
struct MarchedStart {
    long number = 1;             ///< of the blow, from 1
    double rememberedForce = 0;  ///< largest that its rock has felt before [F0]
};

/// Blow with everything that is shown, written or reported about it.
struct Blow {
    Scenario scenario;
    MethodChoice method;
    Groups groups;
    Scales scales;  ///< back to SI; all 1 in a dimensionless scenario
    Problem problem;
    Impact impact;          ///< with the `reason` if there is no result
    ImpactSummary summary;  ///< not valid without a result; nor is `feed`
    /// Feed that the blow requires; nothing where thrustProblem() says why. The cases of all gaps are known
    /// only after a study of them: core/study/thrust.
    std::optional<FeedEstimate> feed;
    std::vector<Alert> alerts;  ///< of the scenario, followed by those of the result
    double runTime = 0;         ///< of the solver only [s]
    /// Start of a blow of many: `summary` then has only what its pages draw, without rebound; no `feed`.
    std::optional<MarchedStart> marched = {};

    bool isSolved() const { return impact.isSolved(); }
    bool isOfString() const { return isString(scenario); }  ///< solved on polynomial cells
    /// Returns the energy that energy shares refer to [W0]: of the followed hammer, or the work of the force.
    double drivenEnergy() const { return drillwave::drivenEnergy(summary, scenario); }
    /// Returns the effective feed force over the largest of the four required, less 1; nullopt if unknown.
    std::optional<double> thrustMargin() const { return feed ? feed->margin() : std::nullopt; }
};

/// Whether the largest forces in the rod are wanted of a blow, for which waves are recorded.
enum class Stresses {
    asNeeded,  ///< for its alerts, where the rod has a strength
    wanted,    ///< whenever they can be computed
};

/// Solves a scenario with `detail` or more; an invalid one is not solved, with the reason. Waves that are too
/// many to be kept are read in passing unless `detail` is Detail::histories; the lattice solves them without
/// stresses. A stop leaves a blow unsolved.
Blow solveBlow(const Scenario& scenario, const MethodChoice& method, Detail detail,
               const std::stop_token& stop = {}, Stresses stresses = Stresses::asNeeded);

/// Does the same with a solver that keeps its workspace, and solves drill strings as exactly as requested.
Blow solveBlow(const Scenario& scenario, const MethodChoice& method, Detail detail,
               const std::stop_token& stop, Stresses stresses, MethodSolver& solver,
               NetworkAccuracy ofString = NetworkAccuracy::sure);

// How a blow was solved, for reports, records and remarks.

/// Returns the method as JSON names it: "polynomial_cells" of a drill string, whichever is given.
std::string_view methodKey(const Scenario& scenario, Method method);

struct SolverWords {
    std::string key;     ///< in JSON: "polynomial_cells"
    Message name;        ///< "lattice of 1000 segments"
    Message asked;       ///< in prose: "method lattice, 1000 segments", "polynomial cells"
    std::string remark;  ///< in files, as remarksOf() reads it again: "method polynomial_cells"
    Message pieces;      ///< number and unit of Impact::pieces: "11 cells"
};
SolverWords solverWords(const Blow& blow);

}  // namespace drillwave
