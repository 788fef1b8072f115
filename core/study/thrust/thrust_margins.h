// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the output `thrust_margin`, the margin of the feed force, for one case after another.
#pragma once

#include <optional>
#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/thrust/gap_rebounds.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Adds the required feed forces over all gaps to Blow::feed of a solved blow. The feed margin in files and
/// JSON requires them. Adds nothing if that takes more than mostPiecesInPassing wave pieces; the command
/// `drillwave thrust` has no such limit.
void addThrustMargin(Blow& blow, const std::stop_token& stop = {});

/// Returns the estimate of the required feed force of a scenario, by solving its blow and using
/// addThrustMargin(). Empty if the blow is not solved or thrustProblem() gives a reason.
std::optional<FeedEstimate> solveFeedEstimate(const Scenario& scenario, const std::stop_token& stop = {});

/// Solver for the feed margin of several cases. A case that differs from an earlier one only in gap,
/// frequency, impulse or feed force needs no further work. Each thread needs its own object.
class ThrustMargins {
  public:
    /// Sets the maximum number of wave pieces of a curve over all gaps. A case whose curve needs more has no
    /// result.
    explicit ThrustMargins(long mostPieces = anyNumberOfPieces) : m_finder(mostPieces) {}

    /// Returns the feed margin: the effective feed force divided by the largest of the four required ones,
    /// minus 1. `cor` is the e of the case's own blow, from which the first required force follows. `problem`
    /// must be that of the scenario. Empty if thrustMarginProblem() gives a reason, if the curve over the
    /// gaps has no result, and after a stop request.
    std::optional<double> of(const Scenario& scenario, const Problem& problem, const Estimate& cor,
                             const std::stop_token& stop);
    /// Returns the estimate of all four required feed forces. `cor` is the coefficient of restitution e of
    /// the case's own blow; `problem` must be that of the scenario. Empty if thrustMarginProblem() gives a
    /// reason, if the curve over the gaps has no result, and after a stop request.
    std::optional<FeedEstimate> estimate(const Scenario& scenario, const Problem& problem,
                                         const Estimate& cor, const std::stop_token& stop);

  private:
    GapReboundFinder m_finder;
};

}  // namespace drillwave
