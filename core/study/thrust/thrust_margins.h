// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the output `thrust_margin`, the margin of the feed force, for one case after another.
#pragma once

#include <optional>
#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/thrust/gap_rebounds.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Adds the required feed forces for all gaps to Blow::feed of a solved blow, so that files and JSON can
/// contain the feed margin. Adds nothing if the study of the gaps needs more than mostPiecesInPassing wave
/// pieces (the solver's unit of work). The command `drillwave thrust` has no such limit.
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

    /// Returns the feed margin: the effective feed force divided by the largest of the four required feed
    /// forces (see ThrustCase), minus 1. `problem` is the solver's input for the blow of the scenario, and
    /// `cor` the coefficient of restitution e of this blow. Empty if thrustMarginProblem() gives a reason,
    /// if the study of all gaps has no result, and after a stop request.
    std::optional<double> of(const Scenario& scenario, const Problem& problem, const Estimate& cor,
                             const std::stop_token& stop);
    /// Returns all four required feed forces of a scenario (see ThrustCase) with their errors. `problem` is
    /// the solver's input for the blow of the scenario, and `cor` the coefficient of restitution e of this
    /// blow. Empty if thrustMarginProblem() gives a reason, if the study of all gaps has no result, and
    /// after a stop request.
    std::optional<FeedEstimate> estimate(const Scenario& scenario, const Problem& problem,
                                         const Estimate& cor, const std::stop_token& stop);

  private:
    GapReboundFinder m_finder;
};

}  // namespace drillwave
