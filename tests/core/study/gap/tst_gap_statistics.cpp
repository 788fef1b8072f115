// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics over the gap: published values, identities, and sums over dense grids of single blows.
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/blow/impact_summary.h"
#include "core/study/gap/gap_statistics.h"
#include "core/wave/exact/exact_solver.h"

using namespace drillwave;

namespace {

Problem problemOf(PulseShape shape, const Groups& groups) {
    return problemOf(pulseForceOf(shape), groups);
}

// paper, Fig. 8, elastic
const Problem fig8 = problemOf(PulseShape::rectangular, {0.5, 1, 10, 0});

/// e at the middles of `count` cells of gap from `start`, one period or more.
std::vector<double> grid(Problem problem, double start, double length, int count) {
    ExactSolver solver;
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        problem.gap = start + length * (i + 0.5) / count;
        values.push_back(solver.solve(problem).cor);
    }
    return values;
}

GapStatistics statisticsOf(const Problem& problem, Detail detail,
                           const std::optional<NormalGap>& normal = {}) {
    double start = gapPeriodStart(problem);
    if (normal) start = std::min(start, lowestGap(*normal));
    return gapStatistics(gapCurve(problem, start, detail), normal);
}

double density(double x, const NormalGap& normal) {
    const double z = (x - normal.mean) / normal.deviation;
    return std::exp(-z * z / 2);
}

}  // namespace

class TestGapStatistics : public QObject {
    Q_OBJECT

  private slots:
    void theExtremesOfThePapersFigure8AreFound();
    void theErrorsStatedHold();
    void theMaximumAtNoGapIsACuspAndTheMinimumIsNot();
    void meanQuantilesAndShareAgreeWithManySingleBlows_data();
    void meanQuantilesAndShareAgreeWithManySingleBlows();
    void quantilesLieBetweenTheExtremesInOrder();
    void theShareFollowsFromTheCrossings();
    void aScatteredGapAgreesWithASumOverBlows_data();
    void aScatteredGapAgreesWithASumOverBlows();
    void aNarrowScatterIsTheBlowAtItsMean();
    void aWideScatterFarOutIsAUniformGap();
    void aScatterFartherOutByPeriodsIsTheSame();
    void theReferenceCaseIsTheSameEverywhere();
    void anElasticSpringKeepsNothingAtAnyGap();
    void theLargestCorCountsGapsBeforeThePeriod();
    void aRodThatIsNearlyStoppedHasHonestErrors();
};

// theory §7: computed with 33 digits, the last digit rounded.
void TestGapStatistics::theExtremesOfThePapersFigure8AreFound() {
    const GapStatistics s = statisticsOf(fig8, Detail::events);
    const GapOutputStatistics& e = s.of(GapOutput::cor);
    QVERIFY(std::abs(e.least.value.value - 0.8419988) < 5.1e-8);
    QVERIFY(std::abs(e.least.gap.value - 0.52711) < 5.1e-6);
    QVERIFY(std::abs(e.largest.value.value - 1.4010824845070556) < 1e-12);
    QCOMPARE(e.largest.gap.value, 0.0);
    QVERIFY(std::abs(s.shareAboveOne.value - 0.548346) < 5.1e-7);
    QCOMPARE(s.crossings.size(), std::size_t{2});
    QVERIFY(std::abs(s.crossings[0].gap.value - 0.326877) < 5.1e-7 && !s.crossings[0].rising);
    QVERIFY(std::abs(s.crossings[1].gap.value - 0.778532) < 5.1e-7 && s.crossings[1].rising);
}

// Against the solver near the places found: nothing lies beyond the extremes by more than the error.
void TestGapStatistics::theErrorsStatedHold() {
    const GapStatistics s = statisticsOf(fig8, Detail::events);
    const GapExtreme& least = s.of(GapOutput::cor).least;
    QVERIFY(least.value.error < 1e-9 && least.gap.error < 1e-5);
    const double width = 10 * least.gap.error;
    for (const double e : grid(fig8, least.gap.value - width, 2 * width, 1000))
        QVERIFY(e >= least.value.value - least.value.error);
    for (const GapCrossing& crossing : s.crossings) {
        QVERIFY(crossing.gap.error < 1e-9);
        const double margin = crossing.gap.error + 1e-13;
        const double before = grid(fig8, crossing.gap.value - margin, 0, 1).front();
        const double after = grid(fig8, crossing.gap.value + margin, 0, 1).front();
        QVERIFY((before < 1) == crossing.rising && (after > 1) == crossing.rising);
    }
}

void TestGapStatistics::theMaximumAtNoGapIsACuspAndTheMinimumIsNot() {
    const GapStatistics s = statisticsOf(fig8, Detail::events);
    QVERIFY(s.of(GapOutput::cor).largest.kind == GapExtreme::Kind::kink);
    QVERIFY(s.of(GapOutput::cor).least.kind == GapExtreme::Kind::smooth);
    QCOMPARE(s.kinks.size(), std::size_t{1});
    QCOMPARE(s.kinks.front().gap, 1.0);
    // One-sided differences; the curvature is of the order of 1.
    const double h = 1e-6;
    const auto e = [&](double gap) { return grid(fig8, gap, 0, 1).front(); };
    QVERIFY(std::abs(s.kinks.front().slopeAfter - (e(h) - e(0)) / h) < 1e-4);
    QVERIFY(std::abs(s.kinks.front().slopeBefore - (e(1) - e(1 - h)) / h) < 1e-4);
    // The larger of two force peaks changes here: a kink of the peak force that is no event.
    QVERIFY(s.of(GapOutput::peakForce).least.kind == GapExtreme::Kind::kink);
}

void TestGapStatistics::meanQuantilesAndShareAgreeWithManySingleBlows_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("tau");
    QTest::newRow("paper Fig. 8, elastic") << static_cast<int>(PulseShape::rectangular) << 1.0 << 10.0;
    QTest::newRow("paper Fig. 8, bilinear") << static_cast<int>(PulseShape::rectangular) << 0.1 << 10.0;
    QTest::newRow("triangular") << static_cast<int>(PulseShape::triangular) << 0.4 << 3.0;
    QTest::newRow("period from a gap of 1 on") << static_cast<int>(PulseShape::rectangular) << 1.0 << 0.3;
}

void TestGapStatistics::meanQuantilesAndShareAgreeWithManySingleBlows() {
    QFETCH(int, shape);
    QFETCH(double, gamma);
    QFETCH(double, tau);
    const Problem problem = problemOf(static_cast<PulseShape>(shape), {0.5, gamma, tau, 0});
    const GapStatistics s = statisticsOf(problem, Detail::cor);
    const int count = 20000;
    std::vector<double> values = grid(problem, gapPeriodStart(problem), 1, count);
    double sum = 0, above = 0;
    for (const double e : values) {
        sum += e;
        above += e > 1 ? 1 : 0;
    }
    std::ranges::sort(values);
    const GapSpread& e = s.of(GapOutput::cor).uniform;
    // The midpoint rule errs by angle · cell² and curvature · cell²; a share by the cells at its ends; a
    // quantile by a few cells times the slope, all slopes being below 3.
    QVERIFY(std::abs(e.mean.value - sum / count) < 3e-9);
    QVERIFY(std::abs(s.shareAboveOne.value - above / count) <= 4.0 / count);
    for (std::size_t i = 0; i < gapQuantiles.size(); ++i) {
        const auto rank = static_cast<std::size_t>(gapQuantiles[i] * count);
        QVERIFY(std::abs(e.quantiles[i].value - values[rank]) < 6.0 / count);
    }
}

void TestGapStatistics::quantilesLieBetweenTheExtremesInOrder() {
    for (const double beta : {0.05, 0.5, 4.0})
        for (const double gamma : {0.1, 0.6, 1.0}) {
            const NormalGap normal{0.4, 0.3};
            const GapStatistics s =
                statisticsOf(problemOf(PulseShape::halfSine, {beta, gamma, 4, 0}), Detail::events, normal);
            for (const GapOutputStatistics& output : s.outputs)
                for (const GapSpread& spread : {output.uniform, *output.normal}) {
                    // rounding, where an output is the same everywhere
                    const double slack = 1e-12;
                    double last = output.least.value.value - slack;
                    for (const Estimate& quantile : spread.quantiles) {
                        QVERIFY(quantile.value >= last - slack);
                        last = quantile.value;
                    }
                    QVERIFY(last <= output.largest.value.value + slack);
                    QVERIFY(spread.mean.value >= output.least.value.value - slack);
                    QVERIFY(spread.mean.value <= output.largest.value.value + slack);
                }
        }
}

void TestGapStatistics::theShareFollowsFromTheCrossings() {
    for (const double beta : {0.2, 0.5, 2.0}) {
        const GapStatistics s =
            statisticsOf(problemOf(PulseShape::rectangular, {beta, 1, 10, 0}), Detail::cor);
        QVERIFY(!s.crossings.empty() && s.crossings.size() % 2 == 0);  // e is periodic
        // From 0 to 1; above 1 at the ends if the first crossing falls.
        double share = s.crossings.front().rising ? 0 : 1;
        for (const GapCrossing& crossing : s.crossings)
            share -= (crossing.rising ? 1 : -1) * crossing.gap.value;
        QVERIFY(std::abs(s.shareAboveOne.value - share) <= s.shareAboveOne.error + 1e-11);
    }
}

void TestGapStatistics::aScatteredGapAgreesWithASumOverBlows_data() {
    QTest::addColumn<double>("tau");
    QTest::addColumn<double>("mean");
    QTest::addColumn<double>("deviation");
    QTest::newRow("inside a period") << 10.0 << 0.5 << 0.05;
    QTest::newRow("across the cusp") << 10.0 << 1.02 << 0.1;
    QTest::newRow("cut off at zero") << 10.0 << 0.1 << 0.5;
    QTest::newRow("over several periods") << 10.0 << 2.3 << 1.5;
    QTest::newRow("before the period begins") << 0.3 << 0.4 << 0.2;
}

void TestGapStatistics::aScatteredGapAgreesWithASumOverBlows() {
    QFETCH(double, tau);
    QFETCH(double, mean);
    QFETCH(double, deviation);
    const NormalGap normal{mean, deviation};
    const Problem problem = problemOf(PulseShape::rectangular, {0.5, 1, tau, 0});
    const GapStatistics s = statisticsOf(problem, Detail::cor, normal);
    const double start = std::max(0.0, mean - 8 * deviation), length = mean + 8 * deviation - start;
    const int count = 40000;
    const std::vector<double> values = grid(problem, start, length, count);
    double sum = 0, weights = 0, above = 0;
    std::vector<std::pair<double, double>> weighted;
    for (int i = 0; i < count; ++i) {
        const double weight = density(start + length * (i + 0.5) / count, normal);
        const double e = values[static_cast<std::size_t>(i)];
        sum += weight * e;
        weights += weight;
        above += e > 1 ? weight : 0;
        weighted.emplace_back(e, weight);
    }
    const GapSpread& spread = *s.of(GapOutput::cor).normal;
    const double cell = length / count;  // midpoint rule, the density being below 10
    QVERIFY(std::abs(spread.mean.value - sum / weights) < 20 * cell * cell);
    QVERIFY(std::abs(s.normalShareAboveOne->value - above / weights) < 20 * cell);
    std::ranges::sort(weighted);
    double reached = 0;
    std::size_t next = 0;
    for (const auto& [e, weight] : weighted) {
        reached += weight / weights;
        if (next == gapQuantiles.size() || reached < gapQuantiles[next]) continue;
        QVERIFY(std::abs(spread.quantiles[next].value - e) < 1e-3);  // where few values are, cells show
        ++next;
    }
}

void TestGapStatistics::aNarrowScatterIsTheBlowAtItsMean() {
    const double e = grid(fig8, 0.3, 0, 1).front();
    const GapStatistics s = statisticsOf(fig8, Detail::cor, NormalGap{0.3, 1e-6});
    const GapSpread& spread = *s.of(GapOutput::cor).normal;
    QVERIFY(std::abs(spread.mean.value - e) < 1e-10);  // curvature · deviation²/2
    QVERIFY(std::abs(spread.quantiles[1].value - e) < 1e-9);
    // The slope of e times 1.6449 standard deviations.
    const double slope = (grid(fig8, 0.3 + 1e-5, 0, 1).front() - e) / 1e-5;
    QVERIFY(std::abs(spread.quantiles[2].value - e - std::abs(slope) * 1.6448536e-6) < 1e-10);
    QCOMPARE(s.normalShareAboveOne->value, 1.0);
}

void TestGapStatistics::aWideScatterFarOutIsAUniformGap() {
    const GapStatistics s = statisticsOf(fig8, Detail::cor, NormalGap{500, 20});
    const GapOutputStatistics& e = s.of(GapOutput::cor);
    // Folded at so many periods a normal density is even to exp(−2π²·400).
    QVERIFY(std::abs(e.normal->mean.value - e.uniform.mean.value) < 1e-12);
    QVERIFY(std::abs(e.normal->quantiles[0].value - e.uniform.quantiles[0].value) < 1e-10);
    QVERIFY(std::abs(s.normalShareAboveOne->value - s.shareAboveOne.value) < 1e-12);
}

void TestGapStatistics::aScatterFartherOutByPeriodsIsTheSame() {
    const GapStatistics a = statisticsOf(fig8, Detail::cor, NormalGap{3.3, 0.2});
    const GapStatistics b = statisticsOf(fig8, Detail::cor, NormalGap{70.3, 0.2});
    // 70.3 has lost two digits of 0.3.
    QVERIFY(std::abs(a.of(GapOutput::cor).normal->mean.value - b.of(GapOutput::cor).normal->mean.value) <
            1e-13);
    QVERIFY(std::abs(a.normalShareAboveOne->value - b.normalShareAboveOne->value) < 1e-12);
}

void TestGapStatistics::theReferenceCaseIsTheSameEverywhere() {
    const Problem problem = problemOf(PulseShape::rigidBody, {0.5, 0.1, 3, 0});
    const GapStatistics s = statisticsOf(problem, Detail::events, NormalGap{0.2, 0.1});
    const double e = grid(problem, 0, 0, 1).front();
    const GapOutputStatistics& output = s.of(GapOutput::cor);
    QVERIFY(output.least.kind == GapExtreme::Kind::everywhere);
    for (const GapSpread& spread : {output.uniform, *output.normal}) {
        QVERIFY(std::abs(spread.mean.value - e) < 1e-15);
        for (const Estimate& quantile : spread.quantiles) QCOMPARE(quantile.value, e);
    }
    QCOMPARE(s.shareAboveOne.value, 0.0);
    QVERIFY(s.crossings.empty() && s.kinks.empty());
}

void TestGapStatistics::anElasticSpringKeepsNothingAtAnyGap() {
    const GapStatistics s = statisticsOf(problemOf(PulseShape::triangular, {0.7, 1, 3, 0}), Detail::events);
    QVERIFY(std::abs(s.of(GapOutput::efficiency).largest.value.value) < 1e-11);
    QVERIFY(s.of(GapOutput::efficiency).largest.kind == GapExtreme::Kind::everywhere);
}

void TestGapStatistics::theLargestCorCountsGapsBeforeThePeriod() {
    const Problem problem = problemOf(PulseShape::rectangular, {5, 0.05, 0.1, 0});
    const double start = gapPeriodStart(problem);
    const double before = std::ranges::max(grid(problem, 0, start, 2000));
    const double period = std::ranges::max(grid(problem, start, 1, 1000));
    QVERIFY(before > period + 0.01);  // or this would show nothing
    const double largest = largestCor(gapCurve(problem, 0, Detail::cor)).value;
    QVERIFY(largest >= before - 1e-11 && largest < before + 1e-3);  // the grid just misses the top
}

// A blow that leaves the rod almost at rest: it drifts for any number of periods, and what follows changes
// with each. The work is bounded, and the errors say what that costs.
void TestGapStatistics::aRodThatIsNearlyStoppedHasHonestErrors() {
    const Problem problem = problemOf(PulseShape::exponential, {5, 1, 0.2, 0});
    const NormalGap normal{0.06, 0.02};
    const GapCurve curve = gapCurve(problem, 0, Detail::cor);
    QVERIFY(curve.solves < 100000);
    const GapSpread spread = *gapStatistics(curve, normal).of(GapOutput::cor).normal;
    QVERIFY(spread.mean.error > 1e-6);
    double sum = 0, weights = 0;
    const int count = 20000;
    const std::vector<double> values = grid(problem, 0, 0.22, count);
    for (int i = 0; i < count; ++i) {
        const double weight = density(0.22 * (i + 0.5) / count, normal);
        sum += weight * values[static_cast<std::size_t>(i)];
        weights += weight;
    }
    QVERIFY(std::abs(spread.mean.value - sum / weights) < spread.mean.error + 1e-5);
}

QTEST_GUILESS_MAIN(TestGapStatistics)
#include "tst_gap_statistics.moc"
