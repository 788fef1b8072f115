// SPDX-License-Identifier: GPL-3.0-or-later
// The closed forms of theory §10 against a rigid rod that is made to bounce, blow after blow.
#include <QTest>

#include <cmath>

#include "core/blow/feed_estimate.h"
#include "core/model/scales.h"

using namespace drillwave;

namespace {

/// A rigid rod on a rock that returns e, struck once in a unit of time by a unit of velocity, pressed to the
/// rock by the acceleration φ − 1. It knows none of the formulas.
class BouncingRod {
  public:
    BouncingRod(double feed, double cor) : m_push(feed - 1), m_cor(cor) {}

    double gap = 0;        ///< between bit and rock, ≥ 0
    double velocity = 0;   ///< towards the rock
    double sinceBlow = 0;  ///< of the last impact, from the blow before it

    /// From just before one blow to just before the next.
    void strike() {
        velocity += 1;
        double left = 1;
        for (int impacts = 0; left > 0 && impacts < mostImpacts; ++impacts) {
            if (gap == 0 && velocity == 0) return;  // pressed to the rock
            const double wait = timeToImpact();
            if (wait >= left) return fly(left);
            fly(wait);
            left -= wait;
            gap = 0;
            sinceBlow = 1 - left;
            velocity *= -m_cor;
        }
        gap = velocity = 0;  // so many bounces that it lies still
    }

    bool atRest() const { return gap < 1e-9 && std::abs(velocity) < 1e-9; }

  private:
    static constexpr int mostImpacts = 10'000;

    /// gap = v t + a t²/2 with v towards the rock.
    double timeToImpact() const {
        if (gap == 0 && velocity > 0) return 0;
        return (-velocity + std::sqrt(velocity * velocity + 2 * m_push * gap)) / m_push;
    }
    void fly(double time) {
        gap -= velocity * time + m_push * time * time / 2;
        velocity += m_push * time;
        if (gap < 0) gap = 0;
    }

    double m_push, m_cor;  // > 0
};

}  // namespace

class TestUndampedMotion : public QObject {
    Q_OBJECT

  private slots:
    void aRodThatIsDisturbedComesBackToTheMotionOfTheTheory_data();
    void aRodThatIsDisturbedComesBackToTheMotionOfTheTheory();
    void aRodRestsBeforeEveryBlowFromTheirBorderOn_data();
    void aRodRestsBeforeEveryBlowFromTheirBorderOn();
    void aFeedBelowTheBlowsLeavesNoForceForTheRod();
    void theFirstReturnIsInTimeFrom1Plus2eOn();
    void bouncingIsNotSteadyOnRockThatReturnsEverything();
    void theMotionEndsWhereTheGapDoes();
    void theExampleOfTheTheory();
    void roundTripsAreCountedWithTheLengthOfTheRod();
};

void TestUndampedMotion::aRodThatIsDisturbedComesBackToTheMotionOfTheTheory_data() {
    QTest::addColumn<double>("cor");
    QTest::addColumn<double>("feed");
    for (const double cor : {0.1, 0.3, 0.41, 0.6, 0.8, 0.95})
        for (const double part : {0.02, 0.2, 0.5, 0.8, 0.98}) {
            const double feed = 1 + part * ((1 + cor) / (1 - cor) - 1);
            QTest::addRow("e = %g, phi = %.4g", cor, feed) << cor << feed;
        }
}

// Started close to it: further away other motions attract the rod as well.
void TestUndampedMotion::aRodThatIsDisturbedComesBackToTheMotionOfTheTheory() {
    QFETCH(double, cor);
    QFETCH(double, feed);
    const UndampedMotion motion = undampedMotion(feed, cor);
    QCOMPARE(motion.kind, UndampedMotion::Kind::bouncing);
    QVERIFY(motion.stable);
    QVERIFY(motion.gap > 0 && motion.delay > 0 && motion.delay < 1);
    BouncingRod rod(feed, cor);
    rod.gap = motion.gap * 1.001;
    rod.velocity = (motion.impactVelocity - 1 - (feed - 1) * motion.delay) * 1.001;
    for (int blow = 0; blow < 4000; ++blow) rod.strike();
    // After 4000 blows the disturbance is e^−4000 of itself, and rounding.
    QVERIFY2(std::abs(rod.gap - motion.gap) < 1e-10, qPrintable(QString::number(rod.gap, 'g', 12)));
    QVERIFY(std::abs(rod.sinceBlow - motion.delay) < 1e-10);
    QVERIFY(std::abs(rod.velocity + 1 + (feed - 1) * motion.delay - motion.impactVelocity) < 1e-10);
}

void TestUndampedMotion::aRodRestsBeforeEveryBlowFromTheirBorderOn_data() {
    QTest::addColumn<double>("cor");
    for (const double cor : {0.0, 0.1, 0.41, 0.7, 0.9}) QTest::addRow("e = %g", cor) << cor;
}

void TestUndampedMotion::aRodRestsBeforeEveryBlowFromTheirBorderOn() {
    QFETCH(double, cor);
    const double border = restingFeed(cor);
    BouncingRod above(border * 1.001, cor);
    above.strike();
    QVERIFY(above.atRest());
    QCOMPARE(undampedMotion(border * 1.001, cor).kind, UndampedMotion::Kind::resting);
    QCOMPARE(undampedMotion(border * 1.001, cor).gap, 0.0);
    if (cor == 0) return;  // then it rests wherever it comes back at all
    BouncingRod below(1 + (border - 1) * 0.99, cor);
    below.strike();
    QVERIFY(!below.atRest());
}

// A machine of any mass that is pressed by φ and gives one unit of momentum to the rod with every blow.
void TestUndampedMotion::aFeedBelowTheBlowsLeavesNoForceForTheRod() {
    for (const double feed : {0.3, 0.99, 1.01, 1.5}) {
        double momentum = 0;  // towards the rock, were the rod never touched between blows
        for (int blow = 0; blow < 1000; ++blow) momentum += feed - 1;
        const bool isPushedBack = undampedMotion(feed, 0.4).kind == UndampedMotion::Kind::pushedBack;
        QCOMPARE(isPushedBack, momentum < 0);
    }
    QCOMPARE(undampedMotion(1, 0.4).kind, UndampedMotion::Kind::pushedBack);
}

// From rest on the rock: one impact at once, and the next within the unit of time or not.
void TestUndampedMotion::theFirstReturnIsInTimeFrom1Plus2eOn() {
    for (const double cor : {0.1, 0.41, 0.9, 1.4}) {
        BouncingRod inTime((1 + 2 * cor) * (1 + 1e-9), cor);
        inTime.strike();
        QVERIFY(inTime.sinceBlow > 0.5);
        BouncingRod late((1 + 2 * cor) * (1 - 1e-9), cor);
        late.strike();
        QCOMPARE(late.sinceBlow, 0.0);
        QVERIFY(late.gap > 0);
    }
}

void TestUndampedMotion::bouncingIsNotSteadyOnRockThatReturnsEverything() {
    for (const double cor : {1.0, 1.2}) {
        const UndampedMotion motion = undampedMotion(2.5, cor);
        QCOMPARE(motion.kind, UndampedMotion::Kind::bouncing);
        QVERIFY(!motion.stable);
        BouncingRod rod(2.5, cor);
        rod.gap = motion.gap * 1.001;
        rod.velocity = motion.impactVelocity - 1 - 1.5 * motion.delay;
        double farthest = 0;
        for (int blow = 0; blow < 200; ++blow) {
            rod.strike();
            if (blow >= 150) farthest = std::max(farthest, std::abs(rod.gap - motion.gap));
        }
        QVERIFY(farthest > 1e-4 * motion.gap);  // where e < 1 it is as good as gone by then
    }
}

void TestUndampedMotion::theMotionEndsWhereTheGapDoes() {
    const double border = restingFeed(0.41);
    QVERIFY(undampedMotion(border * (1 - 1e-9), 0.41).gap < 1e-8);
    QVERIFY(undampedMotion(border * (1 - 1e-9), 0.41).gap >= 0);
    QVERIFY(std::isinf(restingFeed(1)));
    QVERIFY(std::isinf(restingFeed(1.4)));
}

// theory §10: at the paper's thrust and e = 0.41 the bit hangs 2.3 d0 off the rock (T38, 60 Hz).
void TestUndampedMotion::theExampleOfTheTheory() {
    const UndampedMotion motion = undampedMotion(1.41, 0.41);
    Scenario scenario;
    scenario.drill.blowFrequency = 60;
    QVERIFY(std::abs(motion.gap * *roundTripsBetweenBlows(scenario) - 2.3) < 0.05);
}

void TestUndampedMotion::roundTripsAreCountedWithTheLengthOfTheRod() {
    Scenario scenario;
    QVERIFY(!roundTripsBetweenBlows(scenario));
    scenario.drill.blowFrequency = 50;
    scenario.rod.length = propertiesOf(scenario.rod).waveSpeed / 400;  // 2 T f = 1/4
    QVERIFY(std::abs(*roundTripsBetweenBlows(scenario) - 4) < 1e-12);
    QCOMPARE(*stepOfWaves(4.09), 4);
    QCOMPARE(*stepOfWaves(3.91), 4);
    QVERIFY(!stepOfWaves(4.11));
    QVERIFY(!stepOfWaves(5.95));  // 6 is not below 6
    QVERIFY(!stepOfWaves(0.05));
    QVERIFY(!stepOfWaves(8.0));
}

QTEST_GUILESS_MAIN(TestUndampedMotion)
#include "tst_undamped_motion.moc"
