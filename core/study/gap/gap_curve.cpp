// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/blow/impact_summary.h"
#include "core/numeric/brent.h"
#include "core/study/gap/event_order.h"
#include "core/text/message.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

namespace {

constexpr int firstCells = 8;  // to begin with
/// Of a period over which all is smooth: the nodes of each cell.
constexpr long leastSolves = firstCells * static_cast<long>(Chebyshev::mostNodes);
constexpr std::size_t mostHammerCuts = 64;
constexpr double nearestCuts = 1e-11;
constexpr double negligibleImpulse = 1e-13;
/// Of all failed blows: two of those that are beyond the solver. Where a blow nearly stops the rod, it drifts
/// through any number of periods, and the contacts that follow change with every one of them.
constexpr long mostFailedPieces = 50'000'000;

/// One blow after another, each at another gap.
class GapSampler {
  public:
    GapSampler(const Problem& problem, Detail detail, std::stop_token stop, long mostPieces)
        : m_problem(problem),
          m_detail(detail),
          m_stop(std::move(stop)),
          m_piecesLeft(mostPieces),
          m_mostOfABlow(mostPieces / leastSolves) {}

    FitSample operator()(double gap) {
        FitSample sample;
        if (m_piecesLeft <= 0) {
            sample.effort = mostFailedPieces;  // gives up
            m_reason = tooManyPieces;
            return sample;
        }
        m_problem.gap = gap;
        const Impact impact = m_solver.solve(m_problem, m_detail, m_stop);
        // A blow that shows that they will not do ends the work at once.
        m_piecesLeft = impact.pieces > m_mostOfABlow ? 0 : m_piecesLeft - impact.pieces;
        if (impact.outcome != Outcome::rebounded) {
            sample.effort = impact.pieces;
            m_reason = impact.reason;
            return sample;
        }
        sample.solved = true;
        sample.label = impact.contacts;
        sample.error = impact.corError;
        if (m_detail == Detail::cor) {
            sample.values[0] = impact.cor;
            sample.order = static_cast<std::uint64_t>(impact.contacts);
            return sample;
        }
        const ImpactSummary summary = summarize(impact, m_problem);
        sample.values = {summary.cor, summary.peakForce, summary.energy.rockWork};
        sample.order = eventOrder(impact, m_problem.force());
        return sample;
    }

    /// Why there was no answer, the last time that there was none.
    const Message& reason() const { return m_reason; }

  private:
    Problem m_problem;  // with the gap that is being solved
    Detail m_detail;
    std::stop_token m_stop;
    long m_piecesLeft;
    long m_mostOfABlow;
    ExactSolver m_solver;
    Message m_reason;
};

/// Where to look first: evenly, and where the course of the hammer force changes just as the gap closes.
std::vector<double> firstCuts(const GapCurve& curve, const PulseForce& hammer) {
    std::vector<double> cuts;
    for (double period = curve.start; period < curve.end; ++period) {
        for (int i = 0; i < firstCells; ++i) cuts.push_back(period + double(i) / firstCells);
        if (hammer.segments.size() <= mostHammerCuts)
            for (const PulseSegment& segment : hammer.segments)
                cuts.push_back(period + segment.impulseBefore);
    }
    cuts.push_back(curve.end);
    std::ranges::sort(cuts);
    const auto close = [](double a, double b) { return b - a <= nearestCuts; };
    cuts.erase(std::ranges::unique(cuts, close).begin(), cuts.end());
    cuts.back() = curve.end;
    return cuts;
}

/// Where results have begun to repeat themselves they may have a kink: at the whole numbers.
void addPeriods(std::vector<double>& borders, double start, double end) {
    for (double period = start + 1; period <= end; ++period) borders.push_back(period);
    std::ranges::sort(borders);
}

}  // namespace

double gapPeriodStart(const Problem& problem) {
    const PulseForce& pulse = problem.force();
    if (pulse.isRigidBody()) return 0;
    // What is still to come of a pulse with a long tail when it makes no difference any more.
    const auto left = [&](double t) { return 1 - pulse.impulseUntil(t) - negligibleImpulse; };
    const double end = brentRoot(left, 0, left(0), pulse.end, left(pulse.end));
    // The free front end has moved G(s) d0 at time s, G(s) = A(s) + G(s − 2τ), A the impulse of the hammer
    // until then. After a contact at s everything happens as after one at s + 2τ, if the hammer has ended by
    // then.
    const double roundTrip = 2 * problem.transitTime();
    if (end / roundTrip > maximumGapPeriodStart) return std::numeric_limits<double>::infinity();
    double moved = 0;
    for (double s = end - roundTrip; s > 0; s -= roundTrip) moved += pulse.impulseUntil(s);
    return std::ceil(moved);
}

GapCurve gapCurve(const Problem& problem, double start, Detail detail, std::stop_token stop,
                  const GapProgress& progress, long mostPieces) {
    assert(start >= 0 && start <= gapPeriodStart(problem));
    GapCurve curve;
    curve.periodStart = gapPeriodStart(problem);
    if (!std::isfinite(curve.periodStart)) {
        curve.reason = translatable("the hammer pushes longer than the reflections that are computed");
        return curve;
    }
    curve.start = std::min(std::floor(start), curve.periodStart);
    curve.end = curve.periodStart + 1;
    curve.outputCount = detail == Detail::cor ? 1 : gapOutputCount;
    curve.dependsOnGap = !problem.force().isRigidBody();
    const FitSettings settings{
        .count = curve.outputCount,
        .scale = {1, 0, 1},
        .scaleGrows = {false, true, false},  // the peak force is seen only when solving
        .mostFailedEffort = mostFailedPieces};
    GapSampler sampler(problem, detail, stop, mostPieces);
    const FitFunction sample = [&](double gap) { return sampler(gap); };
    const FitProgress upTo = [&](double gap) {
        if (progress) progress((gap - curve.start) / (curve.end - curve.start));
    };
    PiecewiseFit fit = curve.dependsOnGap
                           ? fitPiecewise(settings, firstCuts(curve, problem.force()), sample, stop, upTo)
                           : fitConstant(settings, curve.start, curve.end, sample, stop);
    curve.pieces = std::move(fit.pieces);
    curve.borders = std::move(fit.borders);
    if (curve.dependsOnGap) addPeriods(curve.borders, curve.start, curve.end);
    curve.solves = fit.solves;
    curve.solverError = fit.largestError;
    curve.unsolved = fit.unsolved;
    curve.reason = sampler.reason();
    curve.stopped = stop.stop_requested();
    return curve;
}

GapCurve gapCurve(const Problem& problem, Detail detail, std::stop_token stop, const GapProgress& progress,
                  long mostPieces) {
    return gapCurve(problem, gapPeriodStart(problem), detail, std::move(stop), progress, mostPieces);
}

double GapCurve::value(GapOutput output, double gap) const {
    assert(usable() && gap >= start && static_cast<std::size_t>(output) < outputCount);
    if (gap >= end) gap = periodStart + (gap - std::floor(gap));
    return pieceAt(pieces, gap).outputs[static_cast<std::size_t>(output)](gap);
}

std::vector<double> sampleGaps(const GapCurve& curve) {
    constexpr double farthest = 1.0 / 500;
    return samplePlaces(curve.pieces, farthest);
}

}  // namespace drillwave
