// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a blow as a function of the gap between bit and rock, to a known accuracy.
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

/// Outputs along the gap. The impulse is 1 + e.
enum class GapOutput : std::size_t { cor, peakForce, efficiency };
inline constexpr std::size_t gapOutputCount = valueCount<GapOutput>;

/// Maximum number of returns of the hammer wave before the hammer ends.
inline constexpr double maximumGapPeriodStart = 10'000;

/// Maximum number of wave pieces of all blows of one curve, where the study of all gaps was not requested by
/// name: in a report, and for the margin of the thrust in the files of a run. At four to ten million a second
/// that is two to four seconds, and three curves make a report. A count, not a time, so that the files do not
/// depend on the machine. `gap` and `thrust` themselves have no such limit.
inline constexpr long mostPiecesInPassing = 16'000'000;
inline constexpr long anyNumberOfPieces = std::numeric_limits<long>::max();

/// GapCurve::reason of a curve that was given up because of such a limit.
inline constexpr const char* tooManyPieces = translatable(
    "the waves of its blows at all gaps have more polynomial pieces (wave pieces) than a quick study "
    "permits");

/// The gap δ = d/d0 from which on results have period 1 in it: 0 where the hammer has ended before the first
/// reflection is back, else the next whole number beyond which every contact is late enough (theory §4);
/// infinite beyond maximumGapPeriodStart. A tail of 1e-13 of the impulse is taken as none.
double gapPeriodStart(const Problem& problem);

/// A stretch of gap over which results are smooth; its functions in the order of GapOutput, its label the
/// number of contacts.
using GapPiece = FitPiece;

/// Results over [start, end), the last period [periodStart, end) repeating for ever.
struct GapCurve {
    double start = 0;
    double periodStart = 0;
    double end = 0;
    bool dependsOnGap = true;      ///< false for the reference case
    std::size_t outputCount = 0;   ///< 1 with only the COR, else all
    std::vector<GapPiece> pieces;  ///< ascending, contiguous except for slivers of 1e-12
    std::vector<double> borders;   ///< gaps at which the order of events changes, and the whole numbers
    std::uint64_t solves = 0;      ///< blows solved
    double solverError = 0;        ///< largest bound of the solver on e
    double unsolved = 0;           ///< length of gap without an answer
    Message reason;                ///< why there is none somewhere
    bool stopped = false;          ///< on the stop token: nothing here is complete
    bool usable() const { return !stopped && !pieces.empty(); }
    /// Returns whether there is a result along the whole gap, except for a negligible part.
    bool isComplete() const { return usable() && unsolved <= 1e-6; }

    /// An output at any gap ≥ start. Requires that there is an answer there.
    double value(GapOutput output, double gap) const;
};

/// Called from time to time with the share of the work that is done, 0 … 1.
using GapProgress = std::function<void(double)>;

/// Interpolates the outputs of `detail` (cor: e only; events: all outputs) over [start, periodStart + 1),
/// replacing the gap of `problem`. Pieces end where the order of events changes, found by bracketing to
/// 1e-12, and are halved until polynomials through the solver's values agree with it: to 1e-10 in e and in
/// the efficiency, and relatively in the peak force. 0 ≤ start ≤ periodStart. After `mostPieces` wave pieces
/// in all blows, the rest has no result.
GapCurve gapCurve(const Problem& problem, double start, Detail detail, std::stop_token stop = {},
                  const GapProgress& progress = {}, long mostPieces = anyNumberOfPieces);

/// Interpolates over one period.
GapCurve gapCurve(const Problem& problem, Detail detail, std::stop_token stop = {},
                  const GapProgress& progress = {}, long mostPieces = anyNumberOfPieces);

/// Returns gaps at which to draw the curve: the ends of its pieces, without slivers, at most 1/500 apart.
std::vector<double> sampleGaps(const GapCurve& curve);

}  // namespace drillwave
