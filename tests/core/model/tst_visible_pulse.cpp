// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a hammer force is drawn.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/model/pulse_force.h"

using namespace drillwave;

class VisiblePulseTest : public QObject {
    Q_OBJECT

  private slots:
    void aShortPulseIsSeenWhole() {
        for (const PulseShape shape :
             {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine, PulseShape::trapezoid}) {
            const PulseForce pulse = pulseForceOf(shape);
            QCOMPARE(visibleWavesEnd(pulse), 1.0);
            QCOMPARE(visibleForceEnd(pulse), 1.0);
            QVERIFY(visibleImpulseEnd(pulse) <= 1 && visibleImpulseEnd(pulse) > 0.8);
        }
        QCOMPARE(visibleImpulseEnd(pulseForceOf(PulseShape::rectangular)), 1.0);  // one straight line
    }

    void aFadingPulseIsCutWhereItHasFaded() {
        const PulseForce pulse = pulseForceOf(PulseShape::exponential);
        // 97 % of the impulse are there when e^−t is 3 %
        QVERIFY(std::abs(visibleWavesEnd(pulse) + std::log(0.03)) < 1e-12);
        QVERIFY(visibleImpulseEnd(pulse) >= visibleWavesEnd(pulse));
        QVERIFY(pulse.impulseUntil(visibleImpulseEnd(pulse)) < 0.99);
        QVERIFY(pulse(visibleForceEnd(pulse)) < 0.01 * pulse.peak);
        QVERIFY(visibleForceEnd(pulse) < pulse.end);
    }

    void aStaircaseIsCutBetweenSteps() {
        const PulseForce pulse = pulseForceOf(PulseShape::piston, 6);
        for (const double end : {visibleImpulseEnd(pulse), visibleWavesEnd(pulse), visibleForceEnd(pulse)}) {
            QCOMPARE(end, std::round(end));
            QVERIFY(end > 1 && end < pulse.end);
        }
        // steps are horizontal: the impulse is sampled at their ends
        QCOMPARE(visibleImpulseEnd(pulse), visibleWavesEnd(pulse));
        QVERIFY(pulse(visibleForceEnd(pulse)) < 0.02 * pulse.peak);
        QVERIFY(pulse(visibleForceEnd(pulse) - 0.5) >= 0.02 * pulse.peak);
    }

    void theReferenceCaseHasNoForce() {
        const PulseForce none = pulseForceOf(PulseShape::rigidBody);
        QCOMPARE(visibleImpulseEnd(none), 0.0);
        QCOMPARE(visibleWavesEnd(none), 0.0);
        QCOMPARE(visibleForceEnd(none), 0.0);
        QCOMPARE(impulseTimes(none).size(), std::size_t(1));
    }

    void chordsFollowTheImpulse() {
        for (const PulseShape shape :
             {PulseShape::triangular, PulseShape::halfSine, PulseShape::exponential, PulseShape::piston}) {
            const PulseForce pulse = pulseForceOf(shape, 2);
            const std::vector<double> times = impulseTimes(pulse);
            QVERIFY(std::ranges::is_sorted(times));
            QCOMPARE(times.back(), pulse.end);
            for (std::size_t i = 1; i < times.size(); ++i) {
                const double middle = (times[i - 1] + times[i]) / 2;
                if (pulse.impulseUntil(middle) > 0.97) break;  // not seen
                const double chord = (pulse.impulseUntil(times[i - 1]) + pulse.impulseUntil(times[i])) / 2;
                // of a decay, a chord from a share a of the impulse still to come to b = a − 1/48 misses
                // (a + b)/2 − √(ab), as long as b ≥ 2/48: more than chords of sines and lines do
                QVERIFY(std::abs(chord - pulse.impulseUntil(middle)) < 0.051 / 48);
            }
        }
    }
};

QTEST_GUILESS_MAIN(VisiblePulseTest)
#include "tst_visible_pulse.moc"
