// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a blow as functions of the gap between bit and rock, to a known accuracy.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <stop_token>
#include <vector>

#include "core/numeric/piecewise_fit.h"
#include "core/text/enum_names.h"
#include "core/text/message.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Results of a blow that are computed as functions of the gap: coefficient of restitution e, peak force on
/// the rock, efficiency. The impulse on the rock is not listed because it is 1 + e.
enum class GapOutput : std::size_t { cor, peakForce, efficiency };
inline constexpr std::size_t gapOutputCount = valueCount<GapOutput>;

/// Maximum duration of the hammer force with which results over all gaps can be computed, in round trips of a
/// wave in the rod.
inline constexpr double maximumGapPeriodStart = 10'000;

/// Maximum work of a gap curve that is only a part of another result: number of wave pieces (the solver's
/// unit of work) in all its blows. Such results are reports and the feed margin in result files. At 4–10
/// million pieces per second this takes 2–4 s; a report has three curves.
/// The limit is a count, not a time, so that files do not depend on the computer. The commands `gap` and
/// `thrust`, whose purpose is the curve, have no limit.
inline constexpr long mostPiecesInPassing = 16'000'000;
inline constexpr long anyNumberOfPieces = std::numeric_limits<long>::max();

/// Value of GapCurve::reason if part of the curve has no result because its blows exceed the permitted number
/// of wave pieces.
inline constexpr const char* tooManyPieces =
    translatable("the waves of its blows at all gaps have more polynomial pieces than a quick study permits");

/// Returns the dimensionless gap δ = d/d0 beyond which results repeat with period 1. It is 0 if the hammer
/// force ends before its first reflection returns. Otherwise it is a whole number: for larger gaps, the
/// hammer force ends within one round trip after the first contact (theory §4). Infinity if the force lasts
/// more than maximumGapPeriodStart round trips. A tail of less than 1e-13 of the impulse is neglected.
double gapPeriodStart(const Problem& problem);

/// Interval of gaps over which all results are smooth functions of the gap. The functions have the order of
/// GapOutput. `label` is the number of contacts between bit and rock during the blow.
using GapPiece = FitPiece;

/// Results over dimensionless gaps δ = d/d0 in [start, end). The last period [periodStart, end) repeats for
/// all larger gaps.
struct GapCurve {
    double start = 0;
    double periodStart = 0;
    double end = 0;
    /// Whether the results depend on the gap at all. They do not if a rod without waves arrives with its
    /// initial velocity (reference case).
    bool dependsOnGap = true;
    /// Number of outputs in each piece: 1 if only e was requested, otherwise gapOutputCount.
    std::size_t outputCount = 0;
    /// Pieces of the curve, ascending. In each piece, the results are smooth functions of the gap. Exceptions
    /// are very narrow pieces (slivers) of width 1e-12 around kinks.
    std::vector<GapPiece> pieces;
    /// Gaps δ at which the slope of e may jump, ascending. These are gaps where the order of contact events
    /// changes, and all whole numbers, at which the periods end.
    std::vector<double> borders;
    std::uint64_t solves = 0;  ///< number of blows solved
    double solverError = 0;    ///< largest error bound of the solver for e, over all blows
    double unsolved = 0;       ///< total length of gap δ without a result
    Message reason;            ///< reason why some gaps have no result; empty if all have one
    bool stopped = false;      ///< set if the stop token ended the computation; the curve is then incomplete
    bool usable() const { return !stopped && !pieces.empty(); }
    /// Returns whether the curve has results at nearly all gaps: the total length of δ without a result is at
    /// most 1e-6.
    bool isComplete() const { return usable() && unsolved <= 1e-6; }

    /// Returns an output at any gap δ ≥ start. For gaps beyond `end`, uses that results repeat with period 1.
    /// Requires that the curve has a result there.
    double value(GapOutput output, double gap) const;
};

/// Callback for progress, called from time to time with the completed share of the work, 0 … 1.
using GapProgress = std::function<void(double)>;

/// Returns the results of a blow as functions of the dimensionless gap δ. The gap in `problem` is ignored.
/// The range of δ is from `start`, rounded down to a whole number, to gapPeriodStart(problem) + 1. Requires 0
/// ≤ start ≤ gapPeriodStart(problem).
/// `detail` selects the outputs: cor gives only e, events gives all. Pieces end at gaps where the order of
/// events at the bit changes; these gaps are known to 1e-12. Pieces are halved until polynomials agree with
/// the solver to 1e-10, absolute for e and efficiency, relative for the peak force. If all blows together
/// exceed `mostPieces` wave pieces (the solver's unit of work), the remaining gaps have no result.
GapCurve gapCurve(const Problem& problem, double start, Detail detail, std::stop_token stop = {},
                  const GapProgress& progress = {}, long mostPieces = anyNumberOfPieces);

/// Returns the results of a blow as functions of the gap δ over one period, from gapPeriodStart(problem) to
/// that value + 1. The other arguments are as in gapCurve() with a `start`.
GapCurve gapCurve(const Problem& problem, Detail detail, std::stop_token stop = {},
                  const GapProgress& progress = {}, long mostPieces = anyNumberOfPieces);

/// Returns the gaps δ at which to draw the curve: the ends of its pieces, and points between them so that the
/// spacing is at most 1/500. The ends of very narrow pieces around kinks (slivers) are left out.
std::vector<double> sampleGaps(const GapCurve& curve);

}  // namespace drillwave
