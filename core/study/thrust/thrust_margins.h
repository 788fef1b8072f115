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
/// JSON requires them. Adds nothing if that takes more than mostPiecesInPassing wave pieces (the solver's
/// unit of work). The command `drillwave thrust` has no such limit.
void addThrustMargin(Blow& blow, const std::stop_token& stop = {});

/// Returns the estimate of the required feed force of a scenario, by solving its blow and using
/// addThrustMargin(). Empty if the blow is not solved or thrustProblem() gives a reason.
std::optional<FeedEstimate> solveFeedEstimate(const Scenario& scenario, const std::stop_token& stop = {});

/// Solver for the feed margins of many scenarios. A scenario that differs from an earlier one only in gap,
/// frequency, impulse or feed force needs no study of all gaps again. Each thread needs its own object.
class ThrustMargins {
  public:
    /// Sets the maximum work of a curve over all gaps, in wave pieces (the solver's unit of work). A case
    /// whose curve needs more has no result.
    explicit ThrustMargins(long mostPieces = anyNumberOfPieces) : m_finder(mostPieces) {}

    /// Returns the feed margin: the effective feed force divided by the largest of the four required ones,
    /// minus 1. `cor` is the e of the scenario's own blow, from which the first required force follows;
    /// `problem` is that blow. Empty if thrustMarginProblem() gives a reason, if the curve over the gaps has
    /// no result, and after a stop request.
    std::optional<double> of(const Scenario& scenario, const Problem& problem, const Estimate& cor,
                             const std::stop_token& stop);
    /// Returns the estimate of all four required feed forces of a scenario. `cor` is the coefficient of
    /// restitution e of its blow and `problem` that blow. Empty if thrustMarginProblem() gives a reason, if
    /// the curve over the gaps has no result, and after a stop request.
    std::optional<FeedEstimate> estimate(const Scenario& scenario, const Problem& problem,
                                         const Estimate& cor, const std::stop_token& stop);

  private:
    GapReboundFinder m_finder;
};

}  // namespace drillwave
