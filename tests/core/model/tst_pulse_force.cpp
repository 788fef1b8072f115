// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer force: unit impulse, contiguous pieces, and the shapes of files §1.1.
#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "tests/support/scenario.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

Scenario trapezoid(double rise, double fall) {
    Scenario scenario = dimensionless(PulseShape::trapezoid);
    scenario.pulse.rise = rise;
    scenario.pulse.fall = fall;
    return scenario;
}

Scenario piston(double ratio) {
    Scenario scenario = dimensionless(PulseShape::piston);
    scenario.pulse.piston.impedanceRatio = ratio;
    return scenario;
}

Scenario table(std::vector<TablePoint> points) {
    Scenario scenario = dimensionless(PulseShape::table);
    scenario.pulse.tablePoints = std::move(points);
    return scenario;
}

/// Every shape, and the awkward corners of those with parameters.
std::vector<Scenario> variety() {
    std::vector<Scenario> all{dimensionless(PulseShape::rectangular),
                              dimensionless(PulseShape::triangular),
                              dimensionless(PulseShape::halfSine),
                              dimensionless(PulseShape::exponential),
                              trapezoid(0.2, 0.3),
                              trapezoid(0, 0),
                              trapezoid(0, 1),
                              trapezoid(1, 0),
                              trapezoid(0.7, 0.3),
                              trapezoid(1e-12, 1e-12)};
    for (const double ratio : {1e-6, 0.3, 1.0, 1 + 1e-12, 2.0, 30.0, 1000.0, 4000.0})
        all.push_back(piston(ratio));
    all.push_back(table({{0, 0}, {1, 2}, {2, 0}}));
    all.push_back(table({{-3, 1}, {-2.999999999999, 5}, {7, 5}, {7.5, 0}}));
    all.push_back(table({{0, 1e300}, {1e-300, 0}, {1, 1e300}}));
    return all;
}

/// Simpson's rule on one smooth segment: exact for lines, better than 1e-10 for the others.
double simpson(const PulseForce& force, double from, double to) {
    const int steps = 4000;
    const double h = (to - from) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double a = from + i * h;
        sum += h / 6 * (force(a + 1e-15 * h) + 4 * force(a + h / 2) + force(a + h - 1e-9 * h));
    }
    return sum;
}

}  // namespace

class TestPulseForce : public QObject {
    Q_OBJECT

  private slots:
    void everyPulseHasUnitImpulse();
    void segmentsAreContiguousFromZero();
    void theImpulseIsTheIntegralOfTheForce();
    void theForceIsNeverNegativeAndNeverAboveItsPeak();
    void thereIsNoForceOutsideThePulse();
    void theShapesHaveTheirKnownHeights_data();
    void theShapesHaveTheirKnownHeights();
    void aTriangleIsATrapezoidWithoutPlateau();
    void theExponentialIsCutWhereNothingIsLeft();
    void thePistonsStaircaseIsGeometric();
    void aPistonNoStifferThanTheRodGivesOneStep();
    void aVeryStiffPistonApproachesTheExponential();
    void tableWithTwoValuesAtOneTime_jumpsThere();
    void aTableIsShiftedAndScaledToUnitTime();
    void aTableDoesNotDependOnItsUnits();
    void theReferenceCaseHasNoForce();
};

void TestPulseForce::everyPulseHasUnitImpulse() {
    for (const Scenario& scenario : variety()) {
        const PulseForce force = pulseForceOf(scenario);
        QCOMPARE(force.impulseUntil(force.end), 1.0);
        const double lastStart = force.segments.back().start;
        const double last = force.impulseUntil(std::nextafter(force.end, 0)) - force.impulseUntil(lastStart);
        // The sum over the segments, not the declared total; 1e5 of them added with compensation.
        QVERIFY(std::abs(force.segments.back().impulseBefore + last - 1) < 1e-14);
    }
}

void TestPulseForce::segmentsAreContiguousFromZero() {
    for (const Scenario& scenario : variety()) {
        const PulseForce force = pulseForceOf(scenario);
        double end = 0;
        for (const PulseSegment& segment : force.segments) {
            QVERIFY(segment.length > 0);
            QVERIFY(std::abs(segment.start - end) <= 1e-15 * std::max(1.0, end));
            end = segment.start + segment.length;
        }
        QCOMPARE(force.end, end);
    }
}

void TestPulseForce::theImpulseIsTheIntegralOfTheForce() {
    for (const Scenario& scenario : variety()) {
        const PulseForce force = pulseForceOf(scenario);
        for (std::size_t i = 0; i < force.segments.size(); i += 1 + force.segments.size() / 20) {
            const PulseSegment& segment = force.segments[i];
            const double end = segment.start + segment.length;
            // Steep fronts are narrower than any quadrature resolves; their impulse is checked by the total.
            if (segment.length < 1e-6) continue;
            const double impulse =
                (i + 1 < force.segments.size() ? force.segments[i + 1].impulseBefore : 1.0) -
                segment.impulseBefore;
            // Simpson's rule avoids the ends, where the force jumps, by 1e-9 of a step: that is the error.
            QVERIFY(std::abs(simpson(force, segment.start, end) - impulse) < 1e-8);
            const double half =
                force.impulseUntil(segment.start + segment.length / 2) - segment.impulseBefore;
            QVERIFY(std::abs(simpson(force, segment.start, segment.start + segment.length / 2) - half) <
                    1e-8);
        }
    }
}

void TestPulseForce::theForceIsNeverNegativeAndNeverAboveItsPeak() {
    std::mt19937_64 random(4);
    for (const Scenario& scenario : variety()) {
        const PulseForce force = pulseForceOf(scenario);
        std::uniform_real_distribution<double> time(-0.1, force.end + 0.1);
        for (int i = 0; i < 2000; ++i) {
            const double t = time(random);
            QVERIFY(force(t) >= 0);
            QVERIFY(force(t) <= force.peak * (1 + 1e-15));
        }
    }
}

void TestPulseForce::thereIsNoForceOutsideThePulse() {
    for (const Scenario& scenario : variety()) {
        const PulseForce force = pulseForceOf(scenario);
        QCOMPARE(force(-1e-9), 0.0);
        QCOMPARE(force(force.end), 0.0);
        QCOMPARE(force(std::nan("")), 0.0);
        QCOMPARE(force.impulseUntil(-1), 0.0);
        QCOMPARE(force.impulseUntil(force.end + 5), 1.0);
    }
}

void TestPulseForce::theShapesHaveTheirKnownHeights_data() {
    QTest::addColumn<double>("peak");
    QTest::addColumn<PulseShape>("shape");
    QTest::newRow("rectangular") << 1.0 << PulseShape::rectangular;
    QTest::newRow("triangular") << 2.0 << PulseShape::triangular;
    QTest::newRow("half sine") << std::numbers::pi / 2 << PulseShape::halfSine;
    QTest::newRow("trapezoid 0.2, 0.3") << 1 / 0.75 << PulseShape::trapezoid;
    QTest::newRow("exponential") << 1.0 << PulseShape::exponential;
}

void TestPulseForce::theShapesHaveTheirKnownHeights() {
    QFETCH(double, peak);
    QFETCH(PulseShape, shape);
    QVERIFY(std::abs(pulseForceOf(dimensionless(shape)).peak / peak - 1) < 1e-15);
}

void TestPulseForce::aTriangleIsATrapezoidWithoutPlateau() {
    const PulseForce triangle = pulseForceOf(dimensionless(PulseShape::triangular));
    const PulseForce same = pulseForceOf(trapezoid(0.5, 0.5));
    QVERIFY(triangle.segments == same.segments);
    QCOMPARE(triangle.segments.size(), std::size_t{2});
    QCOMPARE(triangle(0.25), 1.0);
}

void TestPulseForce::theExponentialIsCutWhereNothingIsLeft() {
    const PulseForce force = pulseForceOf(dimensionless(PulseShape::exponential));
    QVERIFY(std::exp(-force.end) < 1e-20);
    QVERIFY(std::abs(force(1) - std::exp(-1)) < 1e-15);
    QVERIFY(std::abs(force.impulseUntil(1) - (1 - std::exp(-1))) < 1e-15);
}

// Long-double products of R, independent of the logarithm that the program uses.
void TestPulseForce::thePistonsStaircaseIsGeometric() {
    for (const double ratio : {1.5, 2.0, 7.0, 100.0, 3000.0}) {
        const PulseForce force = pulseForceOf(piston(ratio));
        const long double reflection = (ratio - 1.0L) / (ratio + 1.0L);
        long double expected = 1 - reflection;
        for (const PulseSegment& step : force.segments) {
            QCOMPARE(step.length, 1.0);
            QCOMPARE(step.slope, 0.0);
            // 46 powers of e at most, each good to a rounding.
            QVERIFY(std::abs(step.value / static_cast<double>(expected) - 1) < 1e-13);
            expected *= reflection;
        }
        QVERIFY(static_cast<double>(expected / (1 - reflection)) < 1e-20);
    }
}

void TestPulseForce::aPistonNoStifferThanTheRodGivesOneStep() {
    const PulseForce rectangle = pulseForceOf(dimensionless(PulseShape::rectangular));
    for (const double ratio : {1e-9, 0.5, 1.0}) {
        const PulseForce force = pulseForceOf(piston(ratio));
        QVERIFY(force.segments == rectangle.segments);
        QCOMPARE(pistonStepCount(ratio), 1.0);
    }
}

// theory §2.1: a hammer of impedance ratio q has the decay time (q/2) t0 of a rigid one of the same mass.
void TestPulseForce::aVeryStiffPistonApproachesTheExponential() {
    const double ratio = 2000;
    const PulseForce steps = pulseForceOf(piston(ratio));
    const PulseForce smooth = pulseForceOf(dimensionless(PulseShape::exponential));
    // At whole steps the impulses differ by the curvature of a step, 1/q².
    for (const double t : {0.1, 1.0, 3.0})
        QVERIFY(std::abs(steps.impulseUntil(t * ratio / 2) - smooth.impulseUntil(t)) < 1 / (ratio * ratio));
}

void TestPulseForce::tableWithTwoValuesAtOneTime_jumpsThere() {
    // A file with two rows of one time is read with the second a rounding later.
    const double first = std::nextafter(0.0, 1.0), last = std::nextafter(2e-4, 1.0);
    const PulseForce force = pulseForceOf(table({{0, 0}, {first, 3}, {2e-4, 3}, {last, 0}}));
    QCOMPARE(force.segments, pulseForceOf(table({{0, 3}, {2e-4, 3}})).segments);
    const PulseForce step = pulseForceOf(table({{0, 1}, {1, 1}, {std::nextafter(1.0, 2.0), 2}, {4, 2}}));
    QCOMPARE(step.segments.size(), std::size_t(2));
    QCOMPARE(step.segments[1].start, 0.25);
}

void TestPulseForce::aTableIsShiftedAndScaledToUnitTime() {
    const PulseForce force = pulseForceOf(table({{10, 0}, {12, 3}, {16, 3}, {18, 0}}));
    QCOMPARE(force.end, 1.0);
    QCOMPARE(force.segments.size(), std::size_t{3});
    QVERIFY(std::abs(force.peak - 1 / 0.75) < 1e-15);
    QVERIFY(std::abs(force(0.125) - force.peak / 2) < 1e-15);
    QVERIFY(std::abs(force(0.5) - force.peak) < 1e-15);
}

void TestPulseForce::aTableDoesNotDependOnItsUnits() {
    Scenario inSi;
    inSi.pulse.shape = PulseShape::table;
    inSi.pulse.tablePoints = {{0, 0}, {0.25e-3, 100e3}, {1e-3, 0}};
    const PulseForce si = pulseForceOf(inSi);
    const PulseForce bare = pulseForceOf(table({{0, 0}, {0.25, 1}, {1, 0}}));
    for (const double t : {0.1, 0.25, 0.7}) QVERIFY(std::abs(si(t) - bare(t)) < 1e-14);
    // F0 of the scales brings the force back to newtons.
    QVERIFY(std::abs(si.peak * scalesOf(inSi).force / 100e3 - 1) < 1e-14);
}

void TestPulseForce::theReferenceCaseHasNoForce() {
    const PulseForce force = pulseForceOf(dimensionless(PulseShape::rigidBody));
    QVERIFY(force.isRigidBody());
    QVERIFY(force.segments.empty());
    QCOMPARE(force.peak, 0.0);
    QCOMPARE(force(0.5), 0.0);
}

QTEST_APPLESS_MAIN(TestPulseForce)
#include "tst_pulse_force.moc"
