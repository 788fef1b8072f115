// SPDX-License-Identifier: GPL-3.0-or-later
// Waves anywhere in the rod, from what the front end has recorded.
#include <QTest>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/wave_curves.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

class TestWaveField : public QObject {
    Q_OBJECT

  private slots:
    void theHammerBlowCrossesTheRodUnchanged() {
        const Impact impact = solve({PulseShape::rectangular, {0.5, 1, 10, 0}}, Detail::histories);
        QCOMPARE(WaveField(impact).positiveWave(0, 0.5), -1.0);
        QCOMPARE(WaveField(impact).positiveWave(0.5, 5.5), -1.0);
        QCOMPARE(WaveField(impact).positiveWave(0.5, 4.9), 0.0);
        QCOMPARE(WaveField(impact).positiveWave(0.5, 6.1), 0.0);
        QCOMPARE(WaveField(impact).negativeWave(0.5, 5.5), 0.0);
    }

    void theFirstForcePeakIsThePapersEquation11() {
        const double beta = 0.5;
        const Impact impact = solve({PulseShape::rectangular, {beta, 1, 10, 0}}, Detail::histories);
        for (const double s : {0.1, 0.7, 0.999})
            QVERIFY(std::abs(impactForce(impact, s) - 2 * (1 - std::exp(-beta * s))) < 1e-14);
        for (const double s : {1.1, 3.0, 15.0})
            QVERIFY(std::abs(impactForce(impact, s) - 2 * (std::exp(-beta * (s - 1)) - std::exp(-beta * s))) <
                    1e-14);
    }

    void forceAtTheFrontEndIsTheSumOfItsWaves() {
        const Impact impact = solve({PulseShape::halfSine, {0.8, 0.2, 2, 0.3}}, Detail::histories);
        for (double t = 2.05; t < 20; t += 0.37) {
            const double normal = WaveField(impact).positiveWave(1, t) + WaveField(impact).negativeWave(1, t);
            QVERIFY(std::abs(-normal - impactForce(impact, t - impact.frontArrival)) < 1e-14);
        }
    }

    void theFieldAtTheBitIsItsHistorySinceTheFirstArrival() {
        for (const PulseShape shape : {PulseShape::triangular, PulseShape::rigidBody}) {
            const Impact impact = solve({shape, {0.8, 0.2, 2, 0}}, Detail::histories);
            const WaveField field(impact);
            const double arrival = shape == PulseShape::rigidBody ? 0 : 2;
            QCOMPARE(field.arrival(), arrival);
            QCOMPARE(field.roundTrip(), 4.0);
            for (double t = -1; t < 30; t += 0.37) {
                QCOMPARE(field.impactForce(t), impactForce(impact, t - arrival));
                QCOMPARE(field.impactImpulse(t), impactImpulse(impact, t - arrival));
            }
        }
    }

    void forceAndVelocityFollowFromTheTwoWaves() {
        const Impact impact = solve({PulseShape::halfSine, {0.8, 0.2, 2, 0.3}}, Detail::histories);
        const WaveField field(impact);
        for (const double xi : {0.0, 0.3, 1.0})
            for (double t = 0.05; t < 20; t += 0.37) {
                const double positive = field.positiveWave(xi, t), negative = field.negativeWave(xi, t);
                QCOMPARE(field.force(xi, t), positive + negative);
                QCOMPARE(field.velocity(xi, t), negative - positive);
            }
    }

    void theRearEndIsFreeAfterTheBlow() {
        const Impact impact = solve({PulseShape::triangular, {0.8, 0.2, 2, 0.3}}, Detail::histories);
        for (double t = 1.05; t < 20; t += 0.37)
            QVERIFY(std::abs(WaveField(impact).positiveWave(0, t) + WaveField(impact).negativeWave(0, t)) <
                    1e-14);
    }

    void theReferenceCaseArrivesWithoutStress() {
        const double tau = 3;
        const Impact impact = solve({PulseShape::rigidBody, {1, 1, tau, 0}}, Detail::histories);
        for (const double xi : {0.0, 0.4, 0.9}) {
            const double p = WaveField(impact).positiveWave(xi, 0.01),
                         n = WaveField(impact).negativeWave(xi, 0.01);
            QVERIFY(std::abs(p + n) < 1e-15);              // no normal force
            QVERIFY(std::abs((n - p) - 1 / tau) < 1e-15);  // velocity v0 = I0/m
        }
    }

    void impulseOfTheHistoryIsTheImpulse() {
        for (const double delta : {0.0, 0.4, 37.25}) {
            const Impact impact = solve({PulseShape::rectangular, {0.5, 0.1, 10, delta}}, Detail::histories);
            const SampledHistory history = sampleHistory(impact);
            QVERIFY(std::abs(history.impulse.back() - impact.impulse) < 1e-13);
            QVERIFY(std::abs(impactImpulse(impact, 1e9) - impact.impulse) < 1e-13);
            QVERIFY(std::is_sorted(history.time.begin(), history.time.end()));
            QVERIFY(std::abs(history.time.front() - impact.frontArrival) < 1e-15);
        }
    }

    // A piston 126 times as stiff as the rod pushes in so many small steps that twenty chords for each of
    // them would fill gigabytes.
    void aMillionPiecesGetNoMoreChordsThanCanBeSeen() {
        ExactSolver solver;
        const Impact impact = solver.solve(
            problemOf(pulseForceOf(PulseShape::piston, 126), {45.7, 0.1, 5.08, 0}), Detail::histories);
        const std::size_t pieces = impact.incident.pieces().size();
        QVERIFY2(pieces > 500'000, qPrintable(QString::number(pieces)));
        const SampledHistory history = sampleHistory(impact);
        QVERIFY(history.time.size() <= std::max<std::size_t>(1'000'000, pieces) + pieces);
        QVERIFY(std::abs(history.impulse.back() - impact.impulse) < 1e-10 * impact.impulse);
    }

    void skippedPeriodsOfFreeFlightCanBeLookedUp() {
        const Impact near = solve({PulseShape::rectangular, {0.5, 1, 3, 0.25}}, Detail::histories);
        const Impact far = solve({PulseShape::rectangular, {0.5, 1, 3, 100.25}}, Detail::histories);
        QVERIFY(!far.skips.empty());
        const double later = 100 * near.roundTrip;
        for (double s = 0.05; s < 30; s += 0.173) {
            QVERIFY(std::abs(impactForce(far, s + later) - impactForce(near, s)) < 1e-12);
            QVERIFY(std::abs(incidentWave(far, s + later) - incidentWave(near, s)) < 1e-12);
        }
        QCOMPARE(incidentWave(far, 50 * near.roundTrip + 0.5), 1.0);  // the blow, running to and fro
        QCOMPARE(incidentWave(far, 50 * near.roundTrip + 1.5), 0.0);
    }

    void sectionWavesAreTheFieldOverOneRoundTripEach() {
        const Impact impact = solve({PulseShape::rectangular, {0.5, 0.1, 10, 0}}, Detail::histories);
        for (const double xi : {0.25, 0.5, 0.9}) {
            const auto waves = sectionWaves(impact, xi, 4);
            QCOMPARE(waves.size(), std::size_t(4));
            for (const SectionWave& wave : waves) {
                const bool forward = wave.number % 2 == 0;
                const double arrival = (wave.number + (forward ? xi : 1 - xi)) * 10;
                QVERIFY(std::abs(wave.curve.time.front() - arrival) < 1e-12);
                QVERIFY(std::abs(wave.curve.time.back() - arrival - 20) < 1e-9);
                for (std::size_t i = 0; i + 1 < wave.curve.time.size(); i += 5) {
                    if (wave.curve.time[i + 1] - wave.curve.time[i] < 1e-6) continue;  // at a jump
                    const double t = wave.curve.time[i] + 1e-9;
                    const double field = forward ? WaveField(impact).positiveWave(xi, t)
                                                 : WaveField(impact).negativeWave(xi, t);
                    QVERIFY(std::abs(wave.curve.value[i] - field) < 1e-7);
                }
            }
        }
    }

    void aSectionWaveIsThereForOneRoundTripAndItsImpulseIsItsIntegral() {
        const double tau = 3, inside = 1e-9;
        const Impact impact = solve({PulseShape::halfSine, {0.8, 0.2, tau, 0}}, Detail::histories);
        const WaveField field(impact);
        for (const double xi : {0.25, 0.9})
            for (int number = 0; number < 4; ++number) {
                const bool forward = number % 2 == 0;
                const double begin = (number + (forward ? xi : 1 - xi)) * tau, end = begin + 2 * tau;
                const auto wave = [&](double t) { return sectionWave(impact, xi, number, t); };
                const auto impulse = [&](double t) { return sectionWaveImpulse(impact, xi, number, t); };
                QVERIFY(std::isnan(wave(begin - inside)) && std::isnan(wave(end + inside)));
                QCOMPARE(impulse(begin - 5), impulse(begin));
                QCOMPARE(impulse(end + 5), impulse(end));
                constexpr int steps = 20000;
                const double step = 2 * tau / steps;
                double sum = 0;
                for (int i = 0; i < steps; ++i) {
                    const double t = begin + (i + 0.5) * step;
                    QCOMPARE(wave(t), forward ? field.positiveWave(xi, t) : field.negativeWave(xi, t));
                    sum += step * wave(t);
                }
                // Midpoints: step²/24 times the slopes, kinks included.
                QVERIFY(std::abs(impulse(end) - impulse(begin) - sum) < 1e-6);
            }
    }

    // Where a wave ends the next one arrives, often with a jump; the times of both carry their own rounding.
    void aWaveBeginsBehindItsFrontAndEndsBeforeTheNext() {
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::piston, PulseShape::rigidBody})
            for (const double tau : {0.7, 1.0 / 3, 3.3, 6.1, 10.0, 123.456})
                for (const double xi : {0.0, 0.1, 0.5, 1.0}) {
                    const Impact impact = solve({shape, {0.5, 0.3, tau, 0}}, Detail::histories);
                    for (const auto& [number, curve] : sectionWaves(impact, xi, 4)) {
                        const bool forward = number % 2 == 0;
                        const double inside = 1e-9 * tau;
                        const double begin = curve.time.front() + inside, end = curve.time.back() - inside;
                        const auto field = [&](double t) {
                            return forward ? WaveField(impact).positiveWave(xi, t)
                                           : WaveField(impact).negativeWave(xi, t);
                        };
                        QVERIFY(std::abs(curve.time.back() - curve.time.front() - 2 * tau) < 1e-9 * tau);
                        QVERIFY(std::abs(curve.value.front() - field(begin)) < 1e-6);
                        QVERIFY(std::abs(curve.value.back() - field(end)) < 1e-6);
                    }
                }
    }

    void theImpulseOfTheIncidentWaveIsItsIntegral() {
        for (const Scene& scene : {Scene{PulseShape::rectangular, {0.5, 0.1, 10, 0}},
                                   Scene{PulseShape::halfSine, {0.8, 0.2, 0.7, 0.3}},
                                   Scene{PulseShape::rectangular, {0.5, 1, 3, 100.25}},
                                   Scene{PulseShape::rigidBody, {0.5, 0.3, 2, 0}}}) {
            const Impact impact = solve(scene, Detail::histories);
            const double step = impact.roundTrip / 4096;
            double sum = 0;
            // beyond the recording and, where there are some, over the periods left out of it
            const int steps = 4096 * 120;
            for (int i = 0; i < steps; ++i) {
                if (i % 5000 == 0)  // midpoints miss at most half a step at each of the jumps, two a period
                    QVERIFY2(std::abs(sum - incidentImpulse(impact, i * step)) < 2e-3 * (1 + i * step / 20),
                             describe(scene).c_str());
                sum += step * incidentWave(impact, (i + 0.5) * step);
            }
            // Over one period at the end: the momentum that is left.
            const double end = 150.3 * impact.roundTrip;
            QVERIFY(std::abs(incidentImpulse(impact, end + impact.roundTrip) - incidentImpulse(impact, end) -
                             impact.finalMomentum) < 1e-12);
        }
        const Impact reference = solve({PulseShape::rigidBody, {0.5, 0.3, 2, 0}}, Detail::histories);
        QCOMPARE(incidentImpulse(reference, -1), -0.25);  // the uniform wave 1/(2τ) before the impact
    }
};

QTEST_GUILESS_MAIN(TestWaveField)
#include "tst_wave_field.moc"
