// SPDX-License-Identifier: GPL-3.0-or-later
// Results along the gap: as accurate as stated, kinks found, periodic where they are.
#include <QTest>

#include <cmath>
#include <random>

#include "core/blow/impact_summary.h"
#include "core/study/gap/event_order.h"
#include "core/study/gap/gap_curve.h"
#include "core/wave/exact/exact_solver.h"

using namespace drillwave;

namespace {

Problem problemOf(PulseShape shape, const Groups& groups) {
    return problemOf(pulseForceOf(shape, 2), groups);
}

double cor(PulseShape shape, Groups groups, double gap) {
    groups.delta = gap;
    return ExactSolver().solve(problemOf(shape, groups)).cor;
}

}  // namespace

class TestGapCurve : public QObject {
    Q_OBJECT

  private slots:
    void theCurveIsWhatTheSolverSaysAtEveryGap_data();
    void theCurveIsWhatTheSolverSaysAtEveryGap();
    void theCorAloneIsTheSameCurve();
    void theSecondContactSetsInAtABorder();
    void thePeriodBeginsOnceTheHammerHasEnded_data();
    void thePeriodBeginsOnceTheHammerHasEnded();
    void earlierGapsAreNotPeriodic();
    void theReferenceCaseIsOneBlow();
    void aHammerThatPushesForEverIsRefused();
    void aStopEndsTheWork();
    void theWorkEndsAfterTheMostPieces();
    void manyCornersHideNoLaterEvent();
};

void TestGapCurve::theCurveIsWhatTheSolverSaysAtEveryGap_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("beta");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("tau");
    const auto add = [](const char* name, PulseShape shape, double beta, double gamma, double tau) {
        QTest::newRow(name) << static_cast<int>(shape) << beta << gamma << tau;
    };
    add("paper Fig. 8, elastic", PulseShape::rectangular, 0.5, 1, 10);
    add("paper Fig. 8, bilinear", PulseShape::rectangular, 0.5, 0.1, 10);
    add("nearly elastic", PulseShape::rectangular, 0.5, 0.99999999, 10);
    add("soft", PulseShape::triangular, 0.01, 0.1, 5);
    add("stiff: layers of 1e-6", PulseShape::rectangular, 1e6, 0.01, 10);
    add("half sine", PulseShape::halfSine, 0.7, 0.3, 3);
    add("trapezoid", PulseShape::trapezoid, 20, 0.05, 3);
    add("staircase of a piston", PulseShape::piston, 0.5, 0.1, 5);
    add("exponential", PulseShape::exponential, 0.5, 0.1, 0.3);
    add("hammer pushing during reflections", PulseShape::rectangular, 0.5, 0.1, 0.1);
}

void TestGapCurve::theCurveIsWhatTheSolverSaysAtEveryGap() {
    QFETCH(int, shape);
    QFETCH(double, beta);
    QFETCH(double, gamma);
    QFETCH(double, tau);
    Problem problem = problemOf(static_cast<PulseShape>(shape), {beta, gamma, tau, 0});
    const GapCurve curve = gapCurve(problem, Detail::events);
    QVERIFY(curve.usable());
    QCOMPARE(curve.unsolved, 0.0);
    QVERIFY2(curve.solves < 10000, QByteArray::number(curve.solves));
    double last = curve.periodStart;
    for (const GapPiece& piece : curve.pieces) {
        QVERIFY(piece.start >= last && piece.start - last <= 1e-12 && piece.end > piece.start);
        last = piece.end;
    }
    QCOMPARE(last, curve.periodStart + 1);
    ExactSolver solver;
    std::mt19937_64 random(7);
    // As many near the ends, where stiff rock has its layers, as anywhere.
    std::uniform_real_distribution<double> place(0, 1), exponent(-8, 0);
    for (int i = 0; i < 400; ++i) {
        const double near = std::pow(10, exponent(random));
        const double share = i % 2 == 0 ? place(random) : i % 4 == 1 ? near : 1 - near;
        problem.gap = curve.periodStart + share;
        const ImpactSummary s = summarize(solver.solve(problem, Detail::events), problem);
        // 1e-10 is what the curve promises, of the size of the output.
        QVERIFY2(std::abs(curve.value(GapOutput::cor, problem.gap) - s.cor) < 1e-10 + 8 * s.corError,
                 QByteArray::number(problem.gap, 'g', 17));
        QVERIFY(std::abs(curve.value(GapOutput::peakForce, problem.gap) - s.peakForce) < 4e-10 * s.peakForce);
        QVERIFY(std::abs(curve.value(GapOutput::efficiency, problem.gap) - s.energy.rockWork) < 1e-10);
    }
}

void TestGapCurve::theCorAloneIsTheSameCurve() {
    const Problem problem = problemOf(PulseShape::rectangular, {0.5, 0.1, 10, 0});
    const GapCurve full = gapCurve(problem, Detail::events), quick = gapCurve(problem, Detail::cor);
    for (double gap = 0; gap < 1; gap += 0.00137)
        QVERIFY(std::abs(full.value(GapOutput::cor, gap) - quick.value(GapOutput::cor, gap)) < 2e-10);
}

void TestGapCurve::theSecondContactSetsInAtABorder() {
    const GapCurve curve = gapCurve(problemOf(PulseShape::rectangular, {0.5, 1, 10, 0}), Detail::events);
    ExactSolver solver;
    const auto contacts = [&](double gap) {
        return solver.solve(problemOf(PulseShape::rectangular, {0.5, 1, 10, gap})).contacts;
    };
    // Bisection in the test: between no second contact at 0.45 and one at 0.475.
    double without = 0.45, with = 0.475;
    while (with - without > 1e-13) {
        const double middle = (without + with) / 2;
        (contacts(middle) == 1 ? without : with) = middle;
    }
    double nearest = 1;
    for (const double border : curve.borders) nearest = std::min(nearest, std::abs(border - with));
    QVERIFY(nearest < 2e-12);  // two brackets of 1e-12
}

void TestGapCurve::thePeriodBeginsOnceTheHammerHasEnded_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("tau");
    QTest::addColumn<double>("start");
    const auto add = [](const char* name, PulseShape shape, double tau, double start) {
        QTest::newRow(name) << static_cast<int>(shape) << tau << start;
    };
    add("hammer over before the reflection", PulseShape::rectangular, 10, 0);
    add("over just as the reflection is back", PulseShape::rectangular, 0.5, 0);
    // By hand: at s = 1 − 2τ = 0.4 the end has moved A(0.4) = 0.4.
    add("one reflection during the push", PulseShape::rectangular, 0.3, 1);
    // A(0.8) + A(0.6) + A(0.4) + A(0.2) = 2.
    add("four reflections during the push", PulseShape::rectangular, 0.1, 2);
    add("half sine", PulseShape::halfSine, 0.2, 1);
    add("reference case", PulseShape::rigidBody, 0.3, 0);
}

void TestGapCurve::thePeriodBeginsOnceTheHammerHasEnded() {
    QFETCH(int, shape);
    QFETCH(double, tau);
    QFETCH(double, start);
    const auto pulse = static_cast<PulseShape>(shape);
    // The sum in floating point may fall just above a whole number, which is the safe side.
    const double found = gapPeriodStart(problemOf(pulse, {0.5, 0.1, tau, 0}));
    QVERIFY(found == start || (found == start + 1 && tau == 0.1));
    for (double gap = found; gap < found + 1; gap += 0.0313)
        for (const double gamma : {1.0, 0.1}) {
            const Groups groups{0.5, gamma, tau, 0};
            // A gap of a few periods loses a few digits.
            QVERIFY(std::abs(cor(pulse, groups, gap) - cor(pulse, groups, gap + 1)) < 1e-12);
        }
}

// theory §4: β = 0.5, γ = 1, τ = 0.3.
void TestGapCurve::earlierGapsAreNotPeriodic() {
    const GapCurve curve = gapCurve(problemOf(PulseShape::rectangular, {0.5, 1, 0.3, 0}), 0, Detail::cor);
    QCOMPARE(curve.start, 0.0);
    QCOMPARE(curve.periodStart, 1.0);
    QVERIFY(std::abs(curve.value(GapOutput::cor, 0) - 0.95667) < 5e-6);
    QVERIFY(std::abs(curve.value(GapOutput::cor, 1) - 0.99464) < 5e-6);
    QVERIFY(std::abs(curve.value(GapOutput::cor, 2) - 0.99464) < 5e-6);
    QVERIFY(std::abs(curve.value(GapOutput::cor, 7.25) -
                     cor(PulseShape::rectangular, {0.5, 1, 0.3, 0}, 7.25)) < 1e-10);
}

void TestGapCurve::theReferenceCaseIsOneBlow() {
    const GapCurve curve = gapCurve(problemOf(PulseShape::rigidBody, {0.5, 0.1, 3, 0.7}), Detail::events);
    QVERIFY(!curve.dependsOnGap);
    QCOMPARE(curve.solves, std::uint64_t{1});
    QCOMPARE(curve.value(GapOutput::cor, 0.4), cor(PulseShape::rigidBody, {0.5, 0.1, 3, 0}, 0));
}

void TestGapCurve::aHammerThatPushesForEverIsRefused() {
    const GapCurve curve = gapCurve(problemOf(PulseShape::rectangular, {0.5, 0.1, 1e-7, 0}), Detail::cor);
    QVERIFY(!curve.usable());
    QVERIFY(!curve.reason.isEmpty());
}

void TestGapCurve::aStopEndsTheWork() {
    std::stop_source stop;
    const auto progress = [&](double share) {
        if (share > 0.3) stop.request_stop();
    };
    const GapCurve curve = gapCurve(problemOf(PulseShape::rectangular, {0.5, 0.1, 10, 0}), Detail::events,
                                    stop.get_token(), progress);
    QVERIFY(curve.stopped && !curve.usable());
    QVERIFY(curve.pieces.back().end < 0.6);
}

// The count is the total work of the curve: with as much it is whole.
void TestGapCurve::theWorkEndsAfterTheMostPieces() {
    const Problem problem = problemOf(PulseShape::rectangular, {0.5, 0.1, 10, 0});
    const GapCurve whole = gapCurve(problem, Detail::cor);
    QVERIFY(whole.isComplete());
    const long aBlow = ExactSolver().solve(problem, Detail::cor).pieces;
    const auto some = static_cast<long>(whole.solves) * aBlow / 2;
    for (const long mostPieces : {20 * aBlow, some}) {
        const GapCurve given = gapCurve(problem, Detail::cor, {}, {}, mostPieces);
        QVERIFY(given.solves < whole.solves);
        QVERIFY(!given.isComplete() && !given.stopped);
        QCOMPARE(given.reason.text(), std::string(tooManyPieces));
    }
    // Less than any curve takes is known from the first blow.
    QVERIFY(gapCurve(problem, Detail::cor, {}, {}, 20 * aBlow).solves < 20);
    const auto many = static_cast<long>(whole.solves) * 100 * aBlow;
    QCOMPARE(gapCurve(problem, Detail::cor, {}, {}, many).solves, whole.solves);
    QVERIFY(gapCurve(problem, Detail::cor, {}, {}, many).isComplete());
}

// Forty corners on the way up come before all else that happens.
void TestGapCurve::manyCornersHideNoLaterEvent() {
    Problem problem = problemOf(PulseShape::rectangular, {0.5, 0.1, 10, 0.3});
    for (int i = 1; i <= 40; ++i) problem.law.corners.push_back({0.01 * i, 1});
    const auto solved = [&](double gamma) {
        problem.law.gamma = gamma;
        return ExactSolver().solve(problem, Detail::events);
    };
    const Impact soft = solved(0.1), springy = solved(0.9);
    QVERIFY(soft.contacts != springy.contacts);
    QVERIFY(eventOrder(soft, problem.force()) != eventOrder(springy, problem.force()));
}

QTEST_GUILESS_MAIN(TestGapCurve)
#include "tst_gap_curve.moc"
