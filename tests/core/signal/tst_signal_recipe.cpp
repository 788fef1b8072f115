// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <random>

#include "core/model/validation.h"
#include "core/signal/signal_recipe.h"
#include "core/signal/signal_unit.h"

using namespace drillwave;

namespace {

/// A half sine of 100 µs and −1000 µε after 50 µs of rest at 7 µε, every 0.1 µs, with noise of that size.
Samples strainOfABlow(double noise) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> any(-noise, noise);
    Samples samples;
    for (int i = 0; i <= 2000; ++i) {
        const double t = 0.1e-6 * i;
        const double phase = (t - 50e-6) / 100e-6;
        const double pulse = phase > 0 && phase < 1 ? -1000 * std::sin(M_PI * phase) : 0;
        samples.time.push_back(t);
        samples.value.push_back(pulse + 7 + (noise > 0 ? any(random) : 0));
    }
    return samples;
}

// A bar of 20 mm and 210 GPa, compression negative in the table.
constexpr double axialStiffness = 210e9 * M_PI / 4 * 0.02 * 0.02;

SignalRecipe blowRecipe() {
    SignalRecipe recipe;
    recipe.use = SignalUse::blow;
    recipe.zeroLine = ZeroLine::ofFirstSamples;
    recipe.zeroSpan = 40e-6;
    recipe.forcePerNumber = -forcePerNumber(SignalKind::strain, 1e-6, {.axialStiffness = axialStiffness});
    recipe.negatives = Negatives::clipped;
    return recipe;
}

Samples samplesOf(std::vector<double> time, std::vector<double> value) {
    Samples samples;
    samples.time = std::move(time);
    samples.value = std::move(value);
    return samples;
}

double deviationOf(const Samples& samples, double factor, const TablePoints& points, double shift) {
    double largest = 0;
    std::size_t k = 1;
    for (std::size_t i = 0; i < samples.time.size(); ++i) {
        const double t = samples.time[i] - shift;
        if (t < points.front().time || t > points.back().time) continue;
        while (k + 1 < points.size() && points[k].time < t) ++k;
        const TablePoint &a = points[k - 1], &b = points[k];
        const double line = a.force + (b.force - a.force) * (t - a.time) / (b.time - a.time);
        largest = std::max(largest, std::abs(line - factor * samples.value[i]));
    }
    return largest;
}

}  // namespace

class TestSignalRecipe : public QObject {
    Q_OBJECT

  private slots:
    void aBlowFromStrainHasTheImpulseOfItsIntegral();
    void aBlowMayJump();
    void noiseBelowZeroIsClippedAndCounted();
    void aBiasOfNoiseDoesNotScaleTheBlow();
    void aBlowThatPullsIsRefused();
    void theStatedDeviationHolds_data();
    void theStatedDeviationHolds();
    void straightLinesNeedTheirCornersOnly();
    void thePeakIsThatOfTheSamples();
    void thinningIsCloseToTheBestThereIs();
    void trimKeepsWhatIsBetween();
    void zeroLineAndSign();
    void scaledToAnImpulse();
    void aBridgeTellsItsStrain();
    void theStretchAroundThePeakIsFound();
    void whatCannotBeMadeIsRefused_data();
    void whatCannotBeMadeIsRefused();
    void theLeastForcesAreKept();
    void tenMillionSamplesAreThinnedInBoundedWork();
};

// ∫ EA ε dt of a half sine is 2/π of its peak times its length; the trapezoid rule of 1000 samples is off by
// (π/1000)²/12 = 8e-7 of it.
void TestSignalRecipe::aBlowFromStrainHasTheImpulseOfItsIntegral() {
    const Samples samples = strainOfABlow(0);
    SignalRecipe recipe = blowRecipe();
    recipe.points = 50;
    const ShapedSignal blow = shapedSignal(samples, recipe);
    QCOMPARE(blow.problem, std::string());
    const double integral = axialStiffness * 1e-3 * 100e-6 * 2 / M_PI;
    QVERIFY(std::abs(blow.impulse / integral - 1) < 1e-6);
    // The digits that are kept of each of 50 points.
    QVERIFY(std::abs(blow.impulseChange) < 1e-8 * integral);
    QCOMPARE(blow.zero, 7.0);
    QVERIFY(blow.points.size() <= 50);
    QCOMPARE(blow.points.front().time, 0.0);
    QVERIFY(pointProblem(blow.points).reason.isEmpty());
}

// A rectangle as the program itself writes it.
void TestSignalRecipe::aBlowMayJump() {
    const double up = std::nextafter(1e-4, 1), down = std::nextafter(3e-4, 1);
    const ShapedSignal blow = shapedSignal(
        samplesOf({0, 1e-4, up, 3e-4, down, 4e-4}, {0, 0, 255e3, 255e3, 0, 0}), {.use = SignalUse::blow});
    QCOMPARE(blow.points.size(), std::size_t{6});
    QVERIFY(pointProblem(blow.points).reason.isEmpty());
    QVERIFY(std::abs(blow.impulse / 51 - 1) < 1e-8);
}

void TestSignalRecipe::noiseBelowZeroIsClippedAndCounted() {
    const Samples samples = strainOfABlow(20);
    const ShapedSignal blow = shapedSignal(samples, blowRecipe());
    QCOMPARE(blow.problem, std::string());
    // Half of the 1000 samples of rest; all of the bias that it leaves is stated.
    QVERIFY(blow.clipped > 400 && blow.clipped < 600);
    QVERIFY(blow.clippedImpulse > 0);
    SignalRecipe unclipped = blowRecipe();
    unclipped.use = SignalUse::curve;
    unclipped.negatives = Negatives::kept;
    unclipped.points = 10000;
    const double whole = shapedSignal(samples, unclipped).impulse;
    QVERIFY(std::abs(blow.impulse - blow.clippedImpulse - whole) < 1e-8 * whole);
    QVERIFY(pointProblem(blow.points).reason.isEmpty());
}

// A short blow in a long record, whose clipped noise has more impulse than the blow: thinned to a few points
// the noise has another impulse, which is stated, and the blow keeps its height.
void TestSignalRecipe::aBiasOfNoiseDoesNotScaleTheBlow() {
    std::mt19937_64 random(3);
    std::normal_distribution<double> any(0, 5);
    Samples samples;
    for (int i = 0; i < 200'000; ++i) {
        samples.time.push_back(1e-6 * i);
        samples.value.push_back((i > 1000 && i < 1100 ? 1000 : 0) + any(random));
    }
    const ShapedSignal blow =
        shapedSignal(samples, {.use = SignalUse::blow, .negatives = Negatives::clipped, .points = 200});
    QCOMPARE(blow.problem, std::string());
    QVERIFY(std::abs(blow.peak / 1000 - 1) < 0.03);
    QVERIFY(blow.deviation < 40);
    QVERIFY(std::abs(blow.impulseChange) > 0.01 * blow.impulse);
}

void TestSignalRecipe::aBlowThatPullsIsRefused() {
    SignalRecipe recipe = blowRecipe();
    recipe.negatives = Negatives::kept;
    QVERIFY(shapedSignal(strainOfABlow(20), recipe).problem.find("only pushes") != std::string::npos);
    recipe = blowRecipe();
    recipe.forcePerNumber *= -1;
    recipe.from = 60e-6;
    recipe.to = 140e-6;
    QVERIFY(shapedSignal(strainOfABlow(0), recipe).problem.find("no force") != std::string::npos);
}

void TestSignalRecipe::theStatedDeviationHolds_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<double>("noise");
    for (const int points : {2, 3, 10, 100, 1000})
        for (const double noise : {0.0, 5.0, 100.0})
            QTest::addRow("%d points, noise %g", points, noise) << points << noise;
}

void TestSignalRecipe::theStatedDeviationHolds() {
    QFETCH(int, points);
    QFETCH(double, noise);
    const Samples samples = strainOfABlow(noise);
    SignalRecipe recipe;
    recipe.points = static_cast<std::size_t>(points);
    recipe.forcePerNumber = 3;
    const ShapedSignal curve = shapedSignal(samples, recipe);
    QVERIFY(static_cast<int>(curve.points.size()) <= points);
    const double found = deviationOf(samples, 3, curve.points, 0);
    QVERIFY(std::abs(found - curve.deviation) <= 1e-9 * curve.deviation + 1e-9);
}

void TestSignalRecipe::straightLinesNeedTheirCornersOnly() {
    Samples samples;
    for (int i = 0; i <= 1000; ++i) {
        samples.time.push_back(i);
        samples.value.push_back(i < 300 ? i : i < 700 ? 300 : 1000 - i);
    }
    const ShapedSignal curve = shapedSignal(samples, {.points = 100});
    QCOMPARE(curve.points.size(), std::size_t{4});
    QVERIFY(curve.deviation < 1e-6);
}

// The largest sample of an arc need not be a point of the lines in its place.
void TestSignalRecipe::thePeakIsThatOfTheSamples() {
    Samples samples;
    for (int i = -50; i <= 250; ++i) {
        samples.time.push_back(i * 1e-6);
        samples.value.push_back(i > 0 && i < 200 ? 250 * std::sin(M_PI * i / 200) : 0);
    }
    for (const std::size_t points : {std::size_t{6}, std::size_t{20}, std::size_t{1000}}) {
        const ShapedSignal blow =
            shapedSignal(samples, {.use = SignalUse::blow, .forcePerNumber = 1e3, .points = points});
        QVERIFY2(blow.problem.empty(), blow.problem.c_str());
        QCOMPARE(blow.peak, 250e3);
        QCOMPARE(blow.peakTime, 100e-6);
    }
}

// For a parabola, the best polygon of n lines with knots on it is known: each line off by (1/n)²/4.
void TestSignalRecipe::thinningIsCloseToTheBestThereIs() {
    Samples samples;
    for (int i = 0; i <= 100000; ++i) {
        const double t = i / 100000.0;
        samples.time.push_back(t);
        samples.value.push_back(t * t);
    }
    const ShapedSignal curve = shapedSignal(samples, {.points = 21});
    QVERIFY(curve.deviation < 1.05 / (20 * 20) / 4);
}

void TestSignalRecipe::trimKeepsWhatIsBetween() {
    const Samples samples = samplesOf({0, 1, 2, 3, 4}, {5, 6, 7, 8, 9});
    const ShapedSignal curve = shapedSignal(samples, {.from = 1, .to = 3});
    QCOMPARE(curve.points, (TablePoints{{1, 6}, {2, 7}, {3, 8}}));
    QCOMPARE(curve.samples, std::size_t{3});
    QVERIFY(!shapedSignal(samples, {.from = 1.2, .to = 2.8}).problem.empty());
    QVERIFY(!shapedSignal(samples, {.from = 3, .to = 1}).problem.empty());
}

void TestSignalRecipe::zeroLineAndSign() {
    const Samples samples = samplesOf({0, 1, 2, 3}, {10, 12, 1, 11});
    SignalRecipe recipe{.zeroLine = ZeroLine::ofFirstSamples, .zeroSpan = 1, .forcePerNumber = -2};
    QCOMPARE(zeroOf(samples, recipe), 11.0);
    QCOMPARE(signOfPeak(samples, recipe), -1.0);
    QCOMPARE(shapedSignal(samples, recipe).points, (TablePoints{{0, 2}, {1, -2}, {2, 20}, {3, 0}}));
    recipe = {.zeroLine = ZeroLine::chosen, .zeroValue = 1};
    QCOMPARE(shapedSignal(samples, recipe).points, (TablePoints{{0, 9}, {1, 11}, {2, 0}, {3, 10}}));
}

void TestSignalRecipe::scaledToAnImpulse() {
    SignalRecipe recipe = blowRecipe();
    recipe.scaling = Scaling::toImpulse;
    recipe.impulse = 51;
    const ShapedSignal blow = shapedSignal(strainOfABlow(0), recipe);
    QVERIFY(std::abs(blow.impulse - 51) < 1e-7);
    recipe.scaling = Scaling::byFactor;
    recipe.factor = 2;
    SignalRecipe plain = blowRecipe();
    const double once = shapedSignal(strainOfABlow(0), plain).impulse;
    QVERIFY(std::abs(shapedSignal(strainOfABlow(0), recipe).impulse / once - 2) < 1e-8);
}

// A quarter bridge with k = 2 gives 0.5 mV/V for 1000 µε.
void TestSignalRecipe::aBridgeTellsItsStrain() {
    const GaugedBar bar{.axialStiffness = 1e6, .gaugeFactor = 2, .activeGauges = 1};
    QVERIFY(std::abs(0.5 * forcePerNumber(SignalKind::bridge, 1e-3, bar) - 1000) < 1e-9);
    const GaugedBar full{.axialStiffness = 1e6, .gaugeFactor = 2, .activeGauges = 4};
    QVERIFY(std::abs(2 * forcePerNumber(SignalKind::bridge, 1e-3, full) - 1000) < 1e-9);
    QCOMPARE(findSignalUnit("µm/m")->unit.factor, 1e-6);
    QCOMPARE(findSignalUnit("kN")->kind, SignalKind::force);
    QVERIFY(!findSignalUnit("furlong"));
}

// A half sine is at 2 % of its peak asin(0.02)/π of its length, 0.64 µs, from its ends.
void TestSignalRecipe::theStretchAroundThePeakIsFound() {
    const std::optional<RecordSpan> span = spanAroundPeak(strainOfABlow(0), blowRecipe());
    QVERIFY(span.has_value());
    QVERIFY(std::abs(span->from - 50.6e-6) < 0.11e-6);
    QVERIFY(std::abs(span->to - 149.4e-6) < 0.11e-6);
    QVERIFY(!spanAroundPeak(samplesOf({0, 1}, {0, 0}), {}));
}

void TestSignalRecipe::whatCannotBeMadeIsRefused_data() {
    QTest::addColumn<double>("value");
    QTest::addRow("all zero") << 0.0;
    QTest::addRow("overflow") << 1e300;
}

void TestSignalRecipe::whatCannotBeMadeIsRefused() {
    QFETCH(double, value);
    SignalRecipe recipe{.use = SignalUse::blow, .forcePerNumber = 1e10};
    const ShapedSignal blow = shapedSignal(samplesOf({0, 1, 2}, {0, value, 0}), recipe);
    QVERIFY(!blow.problem.empty());
    QVERIFY(blow.points.empty());
    recipe.scaling = Scaling::toImpulse;
    recipe.impulse = 5;
    QVERIFY(!shapedSignal(samplesOf({0, 1, 2}, {0, 0, 0}), recipe).problem.empty());
}

// The finest step of such a size is 0, and that has no logarithm.
void TestSignalRecipe::theLeastForcesAreKept() {
    const ShapedSignal blow =
        shapedSignal(samplesOf({0, 1, 2}, {0, 1e-320, 0}), {.use = SignalUse::blow, .forcePerNumber = 1});
    QCOMPARE(blow.problem, std::string());
    QCOMPARE(blow.points, (TablePoints{{0, 0}, {1, 1e-320}, {2, 0}}));
}

// Noise over all of it: the worst there is for lines. Counted in samples kept, and ended by a stop.
void TestSignalRecipe::tenMillionSamplesAreThinnedInBoundedWork() {
    std::mt19937_64 random(2);
    std::normal_distribution<double> any(0, 1);
    Samples samples;
    for (std::size_t i = 0; i < mostSamples; ++i) {
        samples.time.push_back(1e-8 * static_cast<double>(i));
        samples.value.push_back(any(random));
    }
    const ShapedSignal curve = shapedSignal(samples, {.points = 1000});
    QVERIFY(curve.points.size() <= 1000 && curve.points.size() > 100);
    QVERIFY(std::abs(deviationOf(samples, 1, curve.points, 0) - curve.deviation) < 1e-6);
    std::stop_source stopped;
    stopped.request_stop();
    QCOMPARE(thinnedCurve(samples.time, samples.value, 1000, stopped.get_token()).size(), std::size_t{2});
}

QTEST_APPLESS_MAIN(TestSignalRecipe)
#include "tst_signal_recipe.moc"
