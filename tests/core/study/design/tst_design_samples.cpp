// SPDX-License-Identifier: GPL-3.0-or-later
// Samples, statistics, indices and worst cases of functions whose answers are known.

#include <QTest>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/numeric/normal_quantile.h"
#include "core/study/design/best_design.h"
#include "core/study/design/design_samples.h"
#include "core/study/design/sensitivity.h"
#include "core/study/design/worst_case.h"

using namespace drillwave;

namespace {

constexpr double pi = std::numbers::pi;

using Function = std::function<double(std::span<const double>)>;

/// A function instead of a blow; the number of the design is added.
class Toy : public DesignProblem {
  public:
    Toy(std::vector<Distribution> inputs, Function function, std::uint64_t designs = 1)
        : m_inputs(std::move(inputs)), m_function(std::move(function)), m_designs(designs) {}

    std::uint64_t designCount() const override { return m_designs; }
    std::size_t outputCount() const override { return 1; }
    std::vector<Distribution> distributions(std::uint64_t) const override { return m_inputs; }
    std::unique_ptr<DesignSolver> solver() const override { return std::make_unique<Solver>(m_function); }

  private:
    struct Solver : DesignSolver {
        explicit Solver(Function f) : function(std::move(f)) {}
        Message solve(std::uint64_t design, std::span<const double> values, std::span<double> outputs,
                      const std::stop_token&) override {
            outputs[0] = function(values) + static_cast<double>(design);
            return std::isnan(outputs[0]) ? "there is none" : "";
        }
        Message solveNominal(std::uint64_t design, std::span<double> outputs,
                             const std::stop_token&) override {
            outputs[0] = static_cast<double>(design);
            return {};
        }
        Function function;
    };
    std::vector<Distribution> m_inputs;
    Function m_function;
    std::uint64_t m_designs;
};

Distribution uniform(double low, double high) {
    return {DistributionKind::uniform, low, high};
}

Toy ishigami() {
    return {{uniform(-pi, pi), uniform(-pi, pi), uniform(-pi, pi)}, [](std::span<const double> x) {
                const double sine = std::sin(x[1]);
                return std::sin(x[0]) + 7 * sine * sine + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
            }};
}

std::vector<DesignSamples> sampled(const Toy& toy, std::uint64_t samples = 4096, std::uint64_t seed = 1,
                                   int jobs = 1) {
    const std::vector<Statistic> statistics(customaryStatistics().begin(), customaryStatistics().end());
    return sampleDesigns(toy, {.samples = samples, .seed = seed, .statistics = {statistics}}, {.jobs = jobs});
}

}  // namespace

class TestDesignSamples : public QObject {
    Q_OBJECT

  private slots:
    void normalQuantilesAreThoseOfTables();
    void distributionsHaveTheirQuantiles();
    void pointsFillEveryIntervalAlike();
    void ishigamiHasItsIndices();
    void statedErrorsOfIndicesHoldInNineOfTenSeeds();
    void aSumHasItsSharesAsIndices();
    void aConstantHasNoIndices();
    void statisticsOfEqualSamplesAreExact();
    void statisticsDoNotDependOnTheNumberOfThreads();
    void pointsWithoutAnswerAreLeftOut();
    void worstIsAtLeastEverySample();
    void worstIsFoundOnAKink();
    void worstIsFoundOnABentRidge();
    void worstIsFoundInTheNarrowOfTwoDips();
    void tiesAreWithinTheErrorOfTheDifference();
    void roundingMakesNoDesignBetter();
    void paretoSetsHaveWhatNoneDominates();
};

void TestDesignSamples::normalQuantilesAreThoseOfTables() {
    QVERIFY(std::abs(normalQuantile(0.975) - 1.959963984540054) < 1e-14);
    QVERIFY(std::abs(normalQuantile(1e-10) + 6.361340902404056) < 1e-13);
    QCOMPARE(normalQuantile(0.5), 0.0);
    for (const double u : {1e-15, 1e-6, 0.1, 0.4, 0.9})
        QVERIFY(std::abs(normalShare(normalQuantile(u)) / u - 1) < 1e-13);
}

// Cut at four deviations, 6e-5 of all: quantiles move by less than 1e-3 of the deviation.
void TestDesignSamples::distributionsHaveTheirQuantiles() {
    const Distribution normal(DistributionKind::normal, 70, 140);
    QVERIFY(std::abs(normal.quantile(0.025) - 70) < 0.02);
    QVERIFY(std::abs(normal.quantile(0.975) - 140) < 0.02);
    QCOMPARE(normal.quantile(0.5), 105.0);
    const Distribution lognormal(DistributionKind::lognormal, 0.06, 0.18);
    QVERIFY(std::abs(lognormal.quantile(0.025) / 0.06 - 1) < 1e-3);
    QVERIFY(std::abs(lognormal.quantile(0.5) / std::sqrt(0.06 * 0.18) - 1) < 1e-14);
    const Distribution log(DistributionKind::log, 50, 200);
    QVERIFY(std::abs(log.quantile(0.5) - 100) < 1e-12);
    QVERIFY(std::abs(log.boxPlace(100) - 0.5) < 1e-14);
    // A gap is cut at 0, and what is left is rescaled.
    const Distribution gap(DistributionKind::normal, 0, 0.6, 0);
    QVERIFY(gap.least() >= 0 && gap.least() < 1e-12);
    QVERIFY(std::abs(gap.quantile(normalShare(0) - 0.025) - 0.3) < 0.02);
    const Distribution rows = Distribution::ofRows(3);
    QCOMPARE(rows.quantile(0.34), 1.0);
    QCOMPARE(rows.quantile(1 - 0x1p-53), 2.0);
}

// The first 2^k points of a Sobol sequence have one in each of 2^k equal intervals, whatever digits shift it.
void TestDesignSamples::pointsFillEveryIntervalAlike() {
    const SobolPoints points(6, 7);
    std::array<double, 6> u{};
    for (std::size_t r = 0; r < replicateCount; ++r) {
        std::vector<int> hits(6 * 64);
        for (std::uint64_t n = 0; n < 64; ++n) {
            points.point(r, n, u);
            for (std::size_t i = 0; i < 6; ++i) ++hits[i * 64 + static_cast<std::size_t>(u[i] * 64)];
        }
        for (const int hit : hits) QCOMPARE(hit, 1);
    }
}

// Ishigami and Homma 1990: a = 7, b = 0.1.
void TestDesignSamples::ishigamiHasItsIndices() {
    const Sensitivity found = sensitivityOf(ishigami(), 0, {0}, 8192, 1, {});
    const std::array first{0.3139, 0.4424, 0.0}, total{0.5576, 0.4424, 0.2437};
    for (std::size_t i = 0; i < 3; ++i) {
        const SobolIndex& index = found.outputs[0].indices[i];
        QVERIFY(std::abs(index.first.value - first[i]) < 0.01);
        QVERIFY(std::abs(index.total.value - total[i]) < 0.01);
    }
}

void TestDesignSamples::statedErrorsOfIndicesHoldInNineOfTenSeeds() {
    const double variance = 0.5 + 49.0 / 8 + 0.1 * std::pow(pi, 4) / 5 + 0.01 * std::pow(pi, 8) / 18;
    const double one = std::pow(1 + 0.1 * std::pow(pi, 4) / 5, 2) / 2 / variance;
    const double both = 0.01 * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50) / variance;
    const double two = 49.0 / 8 / variance;
    const std::array<double, 3> first{one, two, 0}, total{one + both, two, both};
    std::array<int, 6> held{};
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Sensitivity found = sensitivityOf(ishigami(), 0, {0}, 8192, seed, {});
        for (std::size_t i = 0; i < 3; ++i) {
            const SobolIndex& index = found.outputs[0].indices[i];
            held[i] += std::abs(index.first.value - first[i]) <= index.first.error;
            held[i + 3] += std::abs(index.total.value - total[i]) <= index.total.error;
        }
    }
    for (const int count : held) QVERIFY2(count >= 90, qPrintable(QString::number(count)));
}

void TestDesignSamples::aSumHasItsSharesAsIndices() {
    const Toy toy({uniform(0, 1), uniform(0, 2), uniform(-1, 3)},
                  [](std::span<const double> x) { return x[0] + x[1] + x[2]; });
    const DesignSamples found = sampled(toy).front();
    // 1/2 + 1 + 1
    QVERIFY(std::abs(found.statistics[0][0].value - 2.5) < 2e-4);
    const Sensitivity indices = sensitivityOf(toy, 0, {0}, 4096, 1, {});
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = std::array{1, 4, 16}[i] / 21.0;
        const SobolIndex& index = indices.outputs[0].indices[i];
        QVERIFY(std::abs(index.first.value - share) < 2e-3);
        QVERIFY(std::abs(index.total.value - share) < 2e-3);
    }
}

void TestDesignSamples::aConstantHasNoIndices() {
    const Toy toy({uniform(0, 1), uniform(0, 1)}, [](std::span<const double>) { return 3.7; });
    const Sensitivity found = sensitivityOf(toy, 0, {0}, 256, 1, {});
    QVERIFY(found.outputs[0].isConstant);
    QVERIFY(found.outputs[0].indices.empty());
}

void TestDesignSamples::statisticsOfEqualSamplesAreExact() {
    const Toy toy({Distribution::ofRows(200)}, [](std::span<const double>) { return 0.3; });
    const std::vector<DesignSamples> designs = sampled(toy);
    for (const SampledValue& value : designs.front().statistics[0]) {
        QCOMPARE(value.value, 0.3);
        QCOMPARE(value.error(), 0.0);
    }
}

void TestDesignSamples::statisticsDoNotDependOnTheNumberOfThreads() {
    const Toy three(
        {uniform(-pi, pi)}, [](std::span<const double> x) { return std::sin(x[0]); }, 3);
    const auto one = sampled(three, 1024, 1, 1), seven = sampled(three, 1024, 1, 7);
    QCOMPARE(one.size(), std::size_t{3});
    QCOMPARE(seven.size(), one.size());
    for (std::size_t d = 0; d < one.size(); ++d)
        for (std::size_t s = 0; s < one[d].statistics[0].size(); ++s) {
            QCOMPARE(seven[d].statistics[0][s].value, one[d].statistics[0][s].value);
            QVERIFY(seven[d].statistics[0][s].replicates == one[d].statistics[0][s].replicates);
        }
    const Toy alone({uniform(-pi, pi)}, [](std::span<const double> x) { return std::sin(x[0]); });
    QCOMPARE(sampled(alone, 1024).front().statistics[0][2].value, one[0].statistics[0][2].value);
    QVERIFY(sampled(alone, 1024, 2).front().statistics[0][2].value != one[0].statistics[0][2].value);
}

void TestDesignSamples::pointsWithoutAnswerAreLeftOut() {
    const auto above = [](double least) {
        return Toy({uniform(0, 1)}, [least](std::span<const double> x) { return x[0] < least ? NAN : x[0]; });
    };
    // one point of each replicate is below 1/2048 of the range
    const DesignSamples few = sampled(above(0x1p-11), 16384).front();
    QCOMPARE(few.unsolved, std::uint64_t{8});
    QCOMPARE(few.reason.text(), std::string("there is none"));
    QVERIFY(!std::isnan(few.statistics[0][0].value));
    const DesignSamples many = sampled(above(0.5)).front();
    QCOMPARE(many.unsolved, std::uint64_t{2048});
    for (const SampledValue& value : many.statistics[0]) QVERIFY(std::isnan(value.value));
}

void TestDesignSamples::worstIsAtLeastEverySample() {
    const auto found = worstCases(ishigami(), 0, {{0, Sense::least}, {0, Sense::largest}}, 1024, 1, {});
    const DesignSamples samples = sampled(ishigami(), 1024).front();
    QVERIFY(found[0]->value <= samples.statistics[0][1].value);
    QVERIFY(found[1]->value >= samples.statistics[0][5].value);
    QCOMPARE(found[1]->sampled, samples.statistics[0][5].value);
    // at x1 = π/2, x2 = ±π/2, x3 = ±π
    QVERIFY(std::abs(found[1]->value - (8 + 0.1 * std::pow(pi, 4))) < 1e-10);
    QCOMPARE(found[1]->searches, worstSearches);
}

// A ridge along which no single coordinate leads on.
void TestDesignSamples::worstIsFoundOnAKink() {
    const Toy toy({uniform(0, 1), uniform(0, 1)}, [](std::span<const double> x) {
        return -std::abs(x[0] - x[1]) * 10 - std::abs(x[0] + x[1] - 1.234);
    });
    const auto found = worstCases(toy, 0, {{0, Sense::largest}}, 4096, 1, {});
    QVERIFY(found[0]->value > -1e-6);
    QVERIFY(std::abs(found[0]->at[0] - 0.617) < 1e-6);
}

// A bent ridge, along which steps in fixed directions hardly lead on.
void TestDesignSamples::worstIsFoundOnABentRidge() {
    const Toy toy({uniform(0, 1), uniform(0, 1), uniform(0, 1)}, [](std::span<const double> x) {
        const double bend = x[1] - 0.5 - 0.3 * std::sin(5 * x[0]), other = x[2] - x[0] * x[0];
        return -1e4 * bend * bend - 1e4 * other * other - std::abs(x[0] - 0.777);
    });
    const auto found = worstCases(toy, 0, {{0, Sense::largest}}, 1024, 1, {});
    QVERIFY2(found[0]->value > -1e-6, QByteArray::number(found[0]->value));
    QVERIFY(found[0]->agreeing >= 1 && found[0]->agreeing <= found[0]->searches);
}

// The worst samples by far are those of a wide dip; a narrow one goes deeper.
void TestDesignSamples::worstIsFoundInTheNarrowOfTwoDips() {
    const Toy toy({uniform(0, 1), uniform(0, 1)}, [](std::span<const double> x) {
        const double wide = std::max(std::hypot(x[0] - 0.3, x[1] - 0.3) - 0.05, 0.0);
        const double narrow = std::hypot(x[0] - 0.8, x[1] - 0.75);
        return std::max(1 - 50 * wide * wide, 1.3 - 60 * narrow);
    });
    const auto found = worstCases(toy, 0, {{0, Sense::largest}}, 4096, 1, {});
    QVERIFY(found[0]->sampled < 1.001);
    QVERIFY(std::abs(found[0]->value - 1.3) < 1e-4);
}

namespace {

DesignSamples design(double first, double second, double scatter = 0) {
    DesignSamples samples{.nominal = {first, second}, .statistics = {}};
    for (const double value : {first, second}) {
        SampledValue sampled{.value = value};
        for (std::size_t r = 0; r < replicateCount; ++r)
            sampled.replicates[r] = value + (r % 2 == 0 ? scatter : -scatter);
        samples.statistics.push_back({sampled});
    }
    return samples;
}

const std::vector<AimOrder> twoAims{{Sense::largest, {0, 0}}, {Sense::least, {1, 0}}};

}  // namespace

// The common part of the errors of all designs cancels: the points are the same.
void TestDesignSamples::tiesAreWithinTheErrorOfTheDifference() {
    const std::vector common{design(1, 0, 0.5), design(1.1, 0, 0.5)};
    const BestDesigns apart = bestOf(common, {twoAims.data(), 1}, {});
    QCOMPARE(*apart.robust, std::size_t{1});
    QVERIFY(apart.ties.empty());
    const std::vector own{design(1, 0, 0.5), design(1.1, 0, 0)};
    QVERIFY(bestOf(own, {twoAims.data(), 1}, {}).ties == std::vector<std::size_t>{0});
    // the next aim tells which of them to take
    QVERIFY(!bestOf(own, {twoAims.data(), 1}, {}).nextBest);
    const std::vector cheaper{design(1, 3, 0.5), design(1.1, 5, 0)};
    const BestDesigns tied = bestOf(cheaper, twoAims, {});
    QVERIFY(tied.robust == std::size_t{1} && tied.nextBest == std::size_t{0});
}

// An aim that is the same for all choices but for its last digits.
void TestDesignSamples::roundingMakesNoDesignBetter() {
    const std::vector designs{design(1, 4), design(1 + 1e-15, 3), design(1 - 1e-15, 5)};
    const BestDesigns best = bestOf(designs, twoAims, {});
    QVERIFY(best.robust == std::size_t{0} && best.nominal == std::size_t{0});
    QVERIFY((best.ties == std::vector<std::size_t>{1, 2}));
    QVERIFY(best.nextBest == std::size_t{1});
    QVERIFY((best.pareto == std::vector{false, true, false}));
}

void TestDesignSamples::paretoSetsHaveWhatNoneDominates() {
    const std::vector designs{design(1, 1), design(2, 2), design(2, 3), design(3, 4), design(1, 1)};
    const BestDesigns best = bestOf(designs, twoAims, {});
    QVERIFY((best.pareto == std::vector{true, true, false, true, true}));
    QCOMPARE(*best.robust, std::size_t{3});
    const LimitOrder limit{.atMost = true, .place = {1, 0}, .bound = 2.5};
    const BestDesigns limited = bestOf(designs, twoAims, {&limit, 1});
    QCOMPARE(*limited.robust, std::size_t{1});
    QVERIFY(!limited.pareto[3]);
    const LimitOrder impossible{.atMost = false, .place = {0, 0}, .bound = 9};
    QVERIFY(!bestOf(designs, twoAims, {&impossible, 1}).robust);
}

QTEST_GUILESS_MAIN(TestDesignSamples)
#include "tst_design_samples.moc"
