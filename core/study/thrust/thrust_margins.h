// SPDX-License-Identifier: GPL-3.0-or-later
// The output `thrust_margin` of one case after another.
#pragma once

#include <optional>
#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/thrust/gap_rebounds.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Completes Blow::feed of a solved blow with the cases of all gaps, by which files and JSON have its margin.
/// Left out where that takes more than mostPiecesInPassing; `drillwave thrust` takes its time.
void addThrustMargin(Blow& blow, const std::stop_token& stop = {});

/// Solves the blow of a scenario for its estimate, with the cases of all gaps as in addThrustMargin().
/// Nothing if it is not solved, or where thrustProblem() says why.
std::optional<FeedEstimate> solveFeedEstimate(const Scenario& scenario, const std::stop_token& stop = {});

/// Shares the common part of cases: no further work for one that differs from an earlier one only in gap,
/// frequency, impulse or feed. One object per thread.
class ThrustMargins {
  public:
    /// Limits the wave pieces, as GapReboundFinder does.
    explicit ThrustMargins(long mostPieces = anyNumberOfPieces) : m_finder(mostPieces) {}

    /// Returns the effective force over the largest of the four required ones, less 1; the first of these is
    /// by `cor`, the e of the case's own blow. nullopt where thrustMarginProblem() says why, if the gaps have
    /// no result, and after a stop. `problem` is that of the scenario.
    std::optional<double> of(const Scenario& scenario, const Problem& problem, const Estimate& cor,
                             const std::stop_token& stop);
    /// Estimates all four cases in the same way.
    std::optional<FeedEstimate> estimate(const Scenario& scenario, const Problem& problem,
                                         const Estimate& cor, const std::stop_token& stop);

  private:
    GapReboundFinder m_finder;
};

}  // namespace drillwave
