// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/blow/impact_summary.h"
#include "core/numeric/brent.h"
#include "core/study/gap/event_order.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

namespace {

constexpr double tolerance = 1e-10;
constexpr double kinkWidth = 1e-12;   // of the bracket around a change of the order of events
constexpr double leastWidth = 1e-11;  // of a piece that is still halved
constexpr int cellsOfPeriod = 8;      // to begin with
constexpr std::size_t mostHammerCuts = 64;
constexpr double negligibleImpulse = 1e-13;
// Limits on the work for results that never become smooth: where a blow nearly stops the rod, it drifts
// through any number of periods, and the contacts that follow change with every one of them.
constexpr std::uint64_t mostSolvesOfCell = 2'000;  // and what earlier cells left over
constexpr std::uint64_t mostKinksOfCell = 100;
constexpr std::uint64_t mostFailuresOfCell = 20;
constexpr long mostFailedPieces = 50'000'000;  // of all failed blows: two of those that are beyond the solver

constexpr std::size_t coarseNodes = 9;
constexpr std::size_t fineNodes = Chebyshev::mostNodes;  // every second one is a coarse node
constexpr std::size_t middleNode = fineNodes / 2;

/// One blow.
struct Sample {
    double gap = 0;
    std::array<double, gapOutputCount> values{};
    double error = 0;
    std::uint64_t order = 0;
    int contacts = 0;
    bool solved = false;
};

using Nodes = std::array<Sample, fineNodes>;
using Errors = std::array<double, gapOutputCount>;

class Builder {
  public:
    Builder(const Problem& problem, Detail detail, std::stop_token stop, const GapProgress& progress)
        : m_problem(problem), m_detail(detail), m_stop(std::move(stop)), m_progress(progress) {}

    GapCurve build(double start);

  private:
    /// What the nodes of an interval tell.
    struct Finding {
        enum Kind {
            smooth,  ///< all nodes taken, and polynomials through them will do
            kink,    ///< at node `at` the order of events is another one
            rough,   ///< neither; the middle is taken, and the coarse nodes if the work limit is reached
        } kind;
        std::size_t at = 0;
        Errors errors{};
    };

    Sample solve(double gap);
    void refine(const Sample& a, const Sample& b);
    Finding probe(Nodes& nodes);
    bool agrees(const Nodes& nodes, Errors& errors);
    void bracketKink(const Sample& first, const Sample& last);
    void accept(std::span<const Sample> nodes, const Errors& errors);
    void acceptAsIs(std::span<const Sample> nodes);
    void acceptUnsolved(double from, double to);
    std::vector<double> firstCuts() const;

    double allowed(std::size_t output) const { return tolerance * m_scale[output] + 8 * m_curve.solverError; }
    bool isSettled(std::span<const Sample> nodes, double factor) const;
    bool ordersCount() const { return m_kinksLeft > 0; }
    bool isHopeless() const { return m_failures >= mostFailuresOfCell || m_failedPieces >= mostFailedPieces; }
    bool mayWork() const { return m_curve.solves < m_solveLimit; }

    Problem m_problem;  ///< with the gap that is being solved
    Detail m_detail;
    std::stop_token m_stop;
    const GapProgress& m_progress;
    ExactSolver m_solver;
    GapCurve m_curve;
    std::array<double, gapOutputCount> m_scale{1, 0, 1};  // the peak force is seen only when solving
    std::uint64_t m_solveLimit = 0;
    std::uint64_t m_kinksLeft = 0;
    std::uint64_t m_failures = 0;
    long m_failedPieces = 0;
};

/// Not solved any more once a stop is requested.
Sample Builder::solve(double gap) {
    Sample sample;
    sample.gap = gap;
    if (m_stop.stop_requested()) return sample;
    m_problem.gap = gap;
    const Impact impact = m_solver.solve(m_problem, m_detail, m_stop);
    ++m_curve.solves;
    if (impact.outcome != Outcome::rebounded) {
        ++m_failures;
        m_failedPieces += impact.pieces;
        m_curve.reason = impact.reason;
        return sample;
    }
    sample.solved = true;
    sample.contacts = impact.contacts;
    sample.error = impact.corError;
    m_curve.solverError = std::max(m_curve.solverError, impact.corError);
    if (m_detail == Detail::cor) {
        sample.values[0] = impact.cor;
        sample.order = static_cast<std::uint64_t>(impact.contacts);
        return sample;
    }
    const ImpactSummary summary = summarize(impact, m_problem);
    sample.values = {summary.cor, summary.peakForce, summary.energy.rockWork};
    sample.order = eventOrder(impact, m_problem.hammer);
    m_scale[1] = std::max(m_scale[1], summary.peakForce);
    return sample;
}

Chebyshev through(std::span<const Sample> nodes, std::size_t output) {
    std::array<double, fineNodes> values{};
    for (std::size_t j = 0; j < nodes.size(); ++j) values[j] = nodes[j].values[output];
    return {nodes.front().gap, nodes.back().gap, std::span(values).first(nodes.size())};
}

/// Whether the last coefficients of all outputs are within `factor` times what is allowed.
bool Builder::isSettled(std::span<const Sample> nodes, double factor) const {
    for (std::size_t i = 0; i < m_curve.outputCount; ++i)
        if (!(through(nodes, i).tail() <= factor * allowed(i))) return false;
    return true;
}

std::array<Sample, coarseNodes> coarse(const Nodes& nodes) {
    std::array<Sample, coarseNodes> chosen;
    for (std::size_t j = 0; j < coarseNodes; ++j) chosen[j] = nodes[2 * j];
    return chosen;
}

/// Whether polynomials through all nodes agree with the solver at two further points, and how well.
bool Builder::agrees(const Nodes& nodes, Errors& errors) {
    const double a = nodes.front().gap, b = nodes.back().gap;
    std::array<Chebyshev, gapOutputCount> curves;
    for (std::size_t i = 0; i < m_curve.outputCount; ++i) {
        curves[i] = through(nodes, i);
        errors[i] = 4 * curves[i].tail();
    }
    for (const double share : {0.2871, 0.9343}) {  // between nodes
        const Sample check = solve(a + share * (b - a));
        if (!check.solved || (ordersCount() && check.order != nodes.front().order)) return false;
        for (std::size_t i = 0; i < m_curve.outputCount; ++i) {
            const double difference = std::abs(curves[i](check.gap) - check.values[i]);
            errors[i] = std::max(errors[i], 2 * difference + check.error);
        }
    }
    for (std::size_t i = 0; i < m_curve.outputCount; ++i)
        if (!(errors[i] <= allowed(i))) return false;
    return true;
}

/// Takes the nodes between the first and the last, as far as is worth it.
Builder::Finding Builder::probe(Nodes& nodes) {
    const double a = nodes.front().gap, b = nodes.back().gap;
    bool solved = nodes.front().solved && nodes.back().solved;
    const auto differs = [&](std::size_t j) {
        nodes[j] = solve(Chebyshev::node(a, b, j, fineNodes));
        solved &= nodes[j].solved;
        return ordersCount() && solved && nodes[j].order != nodes.front().order;
    };
    if (differs(middleNode)) return {Finding::kink, middleNode};
    for (std::size_t j = 2; j + 1 < fineNodes; j += 2) {
        if (!solved && mayWork()) return {Finding::rough};
        if (j != middleNode && differs(j)) return {Finding::kink, j};
    }
    // Twice the nodes square the error: is it worth taking them?
    if (!solved || !isSettled(coarse(nodes), 1 / std::sqrt(tolerance))) return {Finding::rough};
    for (std::size_t j = 1; j < fineNodes; j += 2) {
        if (differs(j)) return {Finding::kink, j};
        if (!solved) return {Finding::rough};
    }
    Finding finding{Finding::smooth};
    if (!isSettled(nodes, 0.25) || !agrees(nodes, finding.errors)) finding.kind = Finding::rough;
    return finding;
}

void Builder::refine(const Sample& a, const Sample& b) {
    if (m_stop.stop_requested() || !(b.gap > a.gap)) return;
    if (isHopeless()) return acceptUnsolved(a.gap, b.gap);
    if (b.gap - a.gap <= leastWidth) return acceptAsIs(std::array{a, b});
    if (ordersCount() && a.solved && b.solved && a.order != b.order) return bracketKink(a, b);

    Nodes nodes;
    nodes.front() = a;
    nodes.back() = b;
    const Finding finding = probe(nodes);
    if (finding.kind == Finding::smooth) return accept(nodes, finding.errors);
    if (finding.kind == Finding::rough && !mayWork()) return acceptAsIs(coarse(nodes));
    const Sample& cut = nodes[finding.kind == Finding::kink ? finding.at : middleNode];
    refine(a, cut);
    refine(cut, b);
}

/// The order of events differs at the ends: finds one place where it changes.
void Builder::bracketKink(const Sample& first, const Sample& last) {
    --m_kinksLeft;
    Sample a = first, b = last;
    while (b.gap - a.gap > kinkWidth) {
        const Sample middle = solve(a.gap + (b.gap - a.gap) / 2);
        if (!middle.solved) {
            refine(first, a);
            refine(a, middle);
            refine(middle, b);
            return refine(b, last);
        }
        (middle.order == first.order ? a : b) = middle;
    }
    refine(first, a);
    acceptAsIs(std::array{a, b});
    m_curve.borders.push_back(a.gap + (b.gap - a.gap) / 2);
    refine(b, last);
}

void Builder::accept(std::span<const Sample> nodes, const Errors& errors) {
    GapPiece piece;
    piece.start = nodes.front().gap;
    piece.end = nodes.back().gap;
    piece.contacts = nodes[nodes.size() / 2].contacts;
    piece.error = errors;
    for (std::size_t i = 0; i < m_curve.outputCount; ++i) {
        piece.outputs[i] = through(nodes, i);
        piece.resolved &= errors[i] <= allowed(i);
    }
    m_curve.pieces.push_back(piece);
    if (m_progress) m_progress((piece.end - m_curve.start) / (m_curve.end - m_curve.start));
}

/// Too short to look closer, or too much work: off by no more than the values differ, in all likelihood.
void Builder::acceptAsIs(std::span<const Sample> nodes) {
    if (!std::ranges::all_of(nodes, &Sample::solved))
        return acceptUnsolved(nodes.front().gap, nodes.back().gap);
    Errors errors{};
    for (std::size_t i = 0; i < m_curve.outputCount; ++i) {
        const auto value = [i](const Sample& sample) { return sample.values[i]; };
        const auto [least, largest] = std::ranges::minmax(nodes, {}, value);
        errors[i] = value(largest) - value(least) + m_curve.solverError;
    }
    accept(nodes, errors);
}

void Builder::acceptUnsolved(double from, double to) {
    GapPiece piece;
    piece.start = from;
    piece.end = to;
    piece.solved = piece.resolved = false;
    m_curve.pieces.push_back(piece);
    m_curve.unsolved += to - from;
}

/// Where to look first: evenly, and where the course of the hammer force changes just as the gap closes.
std::vector<double> Builder::firstCuts() const {
    std::vector<double> cuts;
    for (double period = m_curve.start; period < m_curve.end; ++period) {
        for (int i = 0; i < cellsOfPeriod; ++i) cuts.push_back(period + double(i) / cellsOfPeriod);
        if (m_problem.hammer.segments.size() <= mostHammerCuts)
            for (const PulseSegment& segment : m_problem.hammer.segments)
                cuts.push_back(period + segment.impulseBefore);
    }
    cuts.push_back(m_curve.end);
    std::ranges::sort(cuts);
    const auto close = [](double a, double b) { return b - a <= leastWidth; };
    cuts.erase(std::ranges::unique(cuts, close).begin(), cuts.end());
    cuts.back() = m_curve.end;
    return cuts;
}

GapCurve Builder::build(double start) {
    m_curve.periodStart = gapPeriodStart(m_problem);
    if (!std::isfinite(m_curve.periodStart)) {
        m_curve.reason = "the hammer still pushes when its wave has returned more often than is followed";
        return std::move(m_curve);
    }
    m_curve.start = std::min(std::floor(start), m_curve.periodStart);
    m_curve.end = m_curve.periodStart + 1;
    m_curve.outputCount = m_detail == Detail::cor ? 1 : gapOutputCount;
    if (m_problem.hammer.isRigidBody()) {
        m_curve.dependsOnGap = false;
        const Sample only = solve(m_curve.start);
        Sample atEnd = only;
        atEnd.gap = m_curve.end;
        acceptAsIs(std::array{only, atEnd});
        return std::move(m_curve);
    }
    Sample a = solve(m_curve.start);
    for (const double cut : firstCuts()) {
        if (cut <= a.gap) continue;
        m_solveLimit += mostSolvesOfCell;
        m_kinksLeft += mostKinksOfCell;
        m_failures = 0;
        if (isHopeless()) {
            acceptUnsolved(a.gap, m_curve.end);
            break;
        }
        const Sample b = solve(cut);
        refine(a, b);
        if (b.gap == std::floor(b.gap)) m_curve.borders.push_back(b.gap);
        a = b;
    }
    m_curve.stopped = m_stop.stop_requested();
    return std::move(m_curve);
}

}  // namespace

double gapPeriodStart(const Problem& problem) {
    const PulseForce& pulse = problem.hammer;
    if (pulse.isRigidBody()) return 0;
    // What is still to come of a pulse with a long tail when it makes no difference any more.
    const auto left = [&](double t) { return 1 - pulse.impulseUntil(t) - negligibleImpulse; };
    const double end = brentRoot(left, 0, left(0), pulse.end, left(pulse.end));
    // The free front end has moved G(s) d0 at time s, G(s) = A(s) + G(s − 2τ), A the impulse of the hammer
    // until then. After a contact at s everything happens as after one at s + 2τ, if the hammer has ended by
    // then.
    const double roundTrip = 2 * problem.transitTime;
    if (end / roundTrip > maximumGapPeriodStart) return std::numeric_limits<double>::infinity();
    double moved = 0;
    for (double s = end - roundTrip; s > 0; s -= roundTrip) moved += pulse.impulseUntil(s);
    return std::ceil(moved);
}

GapCurve gapCurve(const Problem& problem, double start, Detail detail, std::stop_token stop,
                  const GapProgress& progress) {
    assert(start >= 0 && start <= gapPeriodStart(problem));
    return Builder(problem, detail, std::move(stop), progress).build(start);
}

GapCurve gapCurve(const Problem& problem, Detail detail, std::stop_token stop, const GapProgress& progress) {
    return gapCurve(problem, gapPeriodStart(problem), detail, std::move(stop), progress);
}

double GapCurve::value(GapOutput output, double gap) const {
    assert(usable() && gap >= start && static_cast<std::size_t>(output) < outputCount);
    if (gap >= end) gap = periodStart + (gap - std::floor(gap));
    const auto next = std::ranges::upper_bound(pieces, gap, {}, &GapPiece::start);
    auto found = next == pieces.begin() ? next : std::prev(next);
    while (!found->solved && found != pieces.begin()) --found;  // the end of the piece before
    const GapPiece& piece = *found;
    assert(piece.solved);
    return piece.outputs[static_cast<std::size_t>(output)](gap);
}

std::vector<double> sampleGaps(const GapCurve& curve) {
    constexpr double farthest = 1.0 / 500, nearest = 1e-9;
    std::vector<double> gaps;
    for (const GapPiece& piece : curve.pieces) {
        if (!piece.solved) continue;
        if (gaps.empty()) gaps.push_back(piece.start);
        const int parts = std::max(1, static_cast<int>(std::ceil((piece.end - piece.start) / farthest)));
        for (int i = 0; i <= parts; ++i) {
            const double gap = i == parts ? piece.end : piece.start + (piece.end - piece.start) * i / parts;
            if (gap - gaps.back() > nearest) gaps.push_back(gap);
        }
    }
    if (!gaps.empty() && curve.end - gaps.back() <= nearest) gaps.back() = curve.end;
    return gaps;
}

}  // namespace drillwave
