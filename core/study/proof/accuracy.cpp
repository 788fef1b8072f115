// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/proof/accuracy.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/model/scales.h"
#include "core/model/validation.h"
#include "core/study/proof/force_difference.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

MethodChoice lattice(int segments, LatticeWaves waves) {
    return {.method = Method::lattice,
            .lattice = {.segments = segments, .waves = waves, .estimate = ErrorEstimate::none}};
}

/// Returns the methods to be measured, in order.
std::vector<MethodChoice> plan(const Problem& problem, const std::vector<int>& ladder) {
    std::vector<MethodChoice> choices{{.method = Method::exact, .lattice = {}}};
    if (methodRefusal(Method::closedForm, problem).isEmpty())
        choices.push_back({.method = Method::closedForm, .lattice = {}});
    for (const LatticeWaves waves : {LatticeWaves::ring, LatticeWaves::moved})
        for (const int segments : ladder) choices.push_back(lattice(segments, waves));
    return choices;
}

/// About how the run time of a choice compares, in moves of a wave by a segment.
double cost(const MethodChoice& choice) {
    if (choice.method != Method::lattice) return 1e4;
    const double segments = choice.lattice.segments;
    constexpr double ringStep = 30;  // moves in the time of one
    return choice.lattice.waves == LatticeWaves::moved ? segments * (segments + ringStep)
                                                       : segments * ringStep;
}

/// Does the rows one after the other.
class Study {
  public:
    Study(const Scenario& scenario, const std::stop_token& stop, const AccuracyProgress& progress,
          const AccuracyRows& onRow)
        : m_problem(problemOf(scenario)), m_stop(stop), m_progress(progress), m_onRow(onRow) {
        m_result.groups = groupsOf(scenario);
    }

    Accuracy run(const std::vector<int>& ladder) {
        m_result.exact = m_solver.solve(m_problem, Detail::histories, {}, m_stop);
        m_result.isStopped = m_stop.stop_requested();
        if (m_result.exact.outcome != Outcome::rebounded) return std::move(m_result);
        solveExtended();
        m_result.residuals = equationResiduals(m_result.exact, m_problem);
        const std::vector<MethodChoice> choices = plan(m_problem, ladder);
        for (const MethodChoice& choice : choices) m_total += cost(choice);
        for (const MethodChoice& choice : choices) {
            if (m_stop.stop_requested()) break;
            m_result.rows.push_back(row(choice));
            m_done += cost(choice);
            if (m_onRow && !m_stop.stop_requested()) m_onRow(m_result);
        }
        m_result.isStopped = m_stop.stop_requested();
        if (!m_result.isStopped) relate();
        return std::move(m_result);
    }

  private:
    void solveExtended() {
        const double start = threadSeconds();
        m_result.extended = solveInExtendedPrecision(m_problem, Detail::histories, m_stop);
        m_result.extendedTime = threadSeconds() - start;
        m_result.extendedDigits = std::numeric_limits<long double>::digits;
    }

    AccuracyRow row(const MethodChoice& choice) {
        AccuracyRow row;
        row.choice = choice;
        const double start = threadSeconds();
        const Impact impact = m_solver.solve(m_problem, Detail::histories, choice, m_stop);
        const double warmUp = threadSeconds() - start;
        row.outcome = impact.outcome;
        row.reason = impact.reason;
        row.pieces = impact.pieces;
        row.events = static_cast<long>(impact.events.size());
        row.contacts = impact.contacts;
        compare(row, impact);
        if (row.outcome == Outcome::rebounded) measure(row, warmUp);
        return row;
    }

    void compare(AccuracyRow& row, const Impact& impact) {
        const bool isExact = row.choice.method == Method::exact;
        const Impact& reference = isExact ? m_result.extended : m_result.exact;
        const bool comparable =
            impact.outcome == Outcome::rebounded && reference.outcome == Outcome::rebounded;
        row.cor = comparable ? impact.cor : unknown;
        // the reference of the others is exact but for what its own row says
        row.corError = std::abs(row.cor - reference.cor) + (isExact ? reference.corError : 0);
        row.peakForceError = comparable ? std::abs(impact.peakForce - reference.peakForce) : unknown;
        row.corEstimate = comparable ? estimate(row, impact) : unknown;
        row.forceError = row.forceErrorInMiddles = unknown;
        if (!comparable) return;
        const ForceDifference difference = forceDifference(impact, reference);
        row.forceError = difference.largest;
        row.forceErrorInMiddles = difference.inMiddles;
    }

    /// The lattice's own estimate; moved waves give the same numbers, so that the ring will do.
    double estimate(const AccuracyRow& row, const Impact& impact) {
        if (row.choice.method != Method::lattice) return impact.corError;
        MethodChoice choice = lattice(row.choice.lattice.segments, LatticeWaves::ring);
        choice.lattice.estimate = ErrorEstimate::fromOtherLattices;
        const Impact ring = m_solver.solve(m_problem, Detail::cor, choice, m_stop);
        return ring.outcome == Outcome::rebounded ? ring.corError : unknown;
    }

    void measure(AccuracyRow& row, double warmUp) {
        double runs = 0;
        const auto solve = [&] { m_sink = m_solver.solve(m_problem, Detail::cor, row.choice, m_stop).cor; };
        const auto onRun = [&] {
            runs += 1;
            if (m_progress)
                m_progress((m_done + cost(row.choice) * std::min(1.0, runs / wantedRuns)) / m_total);
        };
        row.time = measureRunTime(solve, warmUp, m_stop, onRun);
    }

    /// Fills in values that need several rows.
    void relate() {
        m_result.isRelated = true;
        const AccuracyRow* paper = moved(paperSegments);
        const bool isKnown = paper && paper->outcome == Outcome::rebounded;
        const double paperTime = isKnown ? paper->time.median : unknown;
        const AccuracyRow* before = nullptr;
        for (AccuracyRow& row : m_result.rows) {
            row.speed = row.outcome == Outcome::rebounded ? paperTime / row.time.median : unknown;
            const bool onLadder = before && before->choice.method == Method::lattice &&
                                  before->choice.lattice.waves == row.choice.lattice.waves;
            row.observedOrder =
                onLadder ? std::log(before->corError / row.corError) /
                               std::log(double(row.choice.lattice.segments) / before->choice.lattice.segments)
                         : unknown;
            before = &row;
            row.sameAsMoved = agreesWithMoved(row);
        }
        m_result.latticeOrder = order();
    }

    const AccuracyRow* moved(int segments) const {
        const auto found =
            std::ranges::find(m_result.rows, lattice(segments, LatticeWaves::moved), &AccuracyRow::choice);
        return found == m_result.rows.end() ? nullptr : &*found;
    }

    bool agreesWithMoved(const AccuracyRow& row) const {
        if (row.choice.method != Method::lattice || row.outcome != Outcome::rebounded) return true;
        const AccuracyRow& other = *moved(row.choice.lattice.segments);
        if (other.outcome != Outcome::rebounded) return true;
        return other.cor == row.cor && other.forceError == row.forceError && other.pieces == row.pieces &&
               other.peakForceError == row.peakForceError && other.events == row.events;
    }

    /// Least-squares slope of log error over log N.
    double order() const {
        std::vector<double> logSegments, logErrors;
        for (const AccuracyRow& row : m_result.rows)
            if (row.choice.method == Method::lattice && row.choice.lattice.waves == LatticeWaves::ring &&
                row.corError > 0) {
                logSegments.push_back(std::log(row.choice.lattice.segments));
                logErrors.push_back(std::log(row.corError));
            }
        if (logErrors.size() < 2) return unknown;
        const auto size = static_cast<Eigen::Index>(logErrors.size());
        const Eigen::Map<const Eigen::ArrayXd> x(logSegments.data(), size), y(logErrors.data(), size);
        return -((x - x.mean()) * (y - y.mean())).sum() / (x - x.mean()).square().sum();
    }

    Problem m_problem;
    std::stop_token m_stop;
    const AccuracyProgress& m_progress;
    const AccuracyRows& m_onRow;
    MethodSolver m_solver;
    Accuracy m_result;
    double m_total = 0, m_done = 0;
    volatile double m_sink = 0;  ///< so that no solve can be left out
};

/// Why there is nothing to compare.
Message refusalOf(const Scenario& scenario, const std::vector<int>& ladder) {
    if (Message problem = invalidity(scenario); !problem.isEmpty()) return problem;
    if (isString(scenario)) return translatable("the lattices of the paper solve only uniform rods");
    const bool isInRange = std::ranges::all_of(
        ladder, [](int segments) { return segments >= minimumSegments && segments <= maximumSegments; });
    if (isInRange && std::ranges::is_sorted(ladder)) return {};
    return {"%1 %2", {"segments", segmentsProblem()}};
}

}  // namespace

double latticeMoves(const std::vector<int>& ladder) {
    double moves = 0;
    for (const LatticeWaves waves : {LatticeWaves::ring, LatticeWaves::moved})
        for (const int segments : ladder) moves += cost(lattice(segments, waves));
    return moves;
}

std::vector<int> latticeLadder() {
    return {100, 200, 500, 1'000, 2'000, 5'000, paperSegments, 20'000};
}

Accuracy measureAccuracy(const Scenario& scenario, const std::vector<int>& ladder,
                         const std::stop_token& stop, const AccuracyProgress& progress,
                         const AccuracyRows& onRow) {
    Accuracy refused;
    refused.exact.reason = refusalOf(scenario, ladder);
    if (!refused.exact.reason.isEmpty()) return refused;
    return Study(scenario, stop, progress, onRow).run(ladder);
}

}  // namespace drillwave
