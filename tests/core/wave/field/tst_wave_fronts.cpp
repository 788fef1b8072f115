// SPDX-License-Identifier: GPL-3.0-or-later
// Where the lines of an x–t diagram begin.
#include <QTest>

#include "core/wave/field/interesting_time.h"
#include "core/wave/field/wave_field.h"
#include "core/wave/field/wave_fronts.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

class TestWaveFronts : public QObject {
    Q_OBJECT

  private slots:
    void aBlowHasAFrontWhereItBeginsJumpsAndEnds() {
        const auto fronts = [](PulseShape shape) { return pulseFronts(pulseForceOf(shape)); };
        for (const PulseShape shape :
             {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine, PulseShape::trapezoid})
            QCOMPARE(fronts(shape), (std::vector<double>{0, 1}));
        QCOMPARE(fronts(PulseShape::exponential), std::vector<double>{0});
        QCOMPARE(fronts(PulseShape::rigidBody), std::vector<double>{0});
    }

    void aPistonsStaircaseHasAFrontAtEveryStepThatCanBeSeen() {
        // The same impedance: one step. Twice: steps of 1, 1/3, 1/9, … with jumps of 2/3 as much.
        QCOMPARE(pulseFronts(pulseForceOf(PulseShape::piston, 1)), (std::vector<double>{0, 1}));
        QCOMPARE(pulseFronts(pulseForceOf(PulseShape::piston, 2)), (std::vector<double>{0, 1, 2, 3, 4}));
        QVERIFY(pulseFronts(pulseForceOf(PulseShape::piston, 1000)).size() < 10);
    }

    void aTableHasNoJumpsButABeginningAndAnEnd() {
        Scenario scenario;
        scenario.form = ScenarioForm::dimensionless;
        scenario.pulse.shape = PulseShape::table;
        scenario.pulse.tablePoints = {{0, 0}, {1, 3}, {2, 3}, {3, 0}, {4, 0}};
        QCOMPARE(pulseFronts(pulseForceOf(scenario)), (std::vector<double>{0, 1}));
    }

    // The waves are looked up beside each of their fronts: nothing of the blow ahead of it, all of it behind.
    void frontsRunToAndFroAheadOfTheirWaves() {
        const double tau = 3;
        const Impact impact = solve({PulseShape::rectangular, {0.5, 0.1, tau, 0}}, Detail::histories);
        const WaveField field(impact);
        const std::vector<FrontRun> runs = frontRuns(impact, 0, 0, 2 * tau);
        QCOMPARE(runs.size(), std::size_t(4));  // two of them just begin or have just ended
        for (const FrontRun& run : {runs[0], runs[1]}) {
            QCOMPARE(run.number, run.heading == Heading::toBit ? 0L : 1L);
            QCOMPARE(run.timeAtFront, tau);
            for (const double xi : {0.1, 0.6}) {
                const double t = run.timeAt(xi);
                QVERIFY(std::abs(t - (run.heading == Heading::toBit ? xi : 2 - xi) * tau) < 1e-15 * 8);
                QVERIFY(std::abs(run.sectionAt(t) - xi) < 1e-15);
            }
        }
        QCOMPARE(field.positiveWave(0.6, runs[0].timeAt(0.6) - 1e-9), 0.0);
        QCOMPARE(field.positiveWave(0.6, runs[0].timeAt(0.6) + 1e-9), -1.0);
        QCOMPARE(field.negativeWave(0.6, runs[1].timeAt(0.6) - 1e-9), 0.0);
        QVERIFY(field.negativeWave(0.6, runs[1].timeAt(0.6) + 1e-9) > 0.9);  // of a free end but for the rock
    }

    void onlyTheRunsOfTheTimeInViewAreGiven() {
        const Impact impact = solve({PulseShape::rectangular, {0.5, 0.1, 3, 0}}, Detail::histories);
        const std::vector<FrontRun> runs = frontRuns(impact, 1, 600.5, 606.5);
        QVERIFY(!runs.empty() && runs.size() <= 6);
        for (const FrontRun& run : runs) {
            QVERIFY(run.timeAtFront >= 597.5 && run.timeAtFront <= 609.5);
            QCOMPARE(run.timeAtFront, 4 + 6 * std::floor(double(run.number) / 2));
        }
        const Impact reference = solve({PulseShape::rigidBody, {0.5, 0.1, 3, 0}}, Detail::histories);
        const std::vector<FrontRun> fromTheBit = frontRuns(reference, 0, 0, 2);
        QCOMPARE(fromTheBit.front().number, 1L);  // nothing runs to the bit before
        QCOMPARE(fromTheBit.front().timeAtFront, 0.0);
    }

    void theInterestingTimeEndsARoundTripAfterTheBlow() {
        const Scene near{PulseShape::rectangular, {0.5, 0.1, 3, 0}};
        const Impact impact = solve(near, Detail::events);
        QVERIFY(interestingTime(impact, problemOf(near).force()) == (TimeSpan{0, impact.separationTime + 6}));
        const Scene far{PulseShape::rectangular, {0.5, 0.1, 3, 100.25}};
        const Impact late = solve(far, Detail::events);
        const TimeSpan span = interestingTime(late, problemOf(far).force());
        QCOMPARE(span.begin, late.firstContactTime - 9);
        QCOMPARE(span.end, late.separationTime + 6);
    }

    void contactsAreTheTimesFromTouchingToSeparation() {
        RandomScenes scenes(engineeringDomain, 3);
        scenes.forEachSolved(200, Detail::events, [](const Scene& scene, const Impact& impact) {
            const auto contacts = contactIntervals(impact);
            QCOMPARE(static_cast<int>(contacts.size()), impact.contacts);
            double sum = 0;
            for (std::size_t i = 0; i < contacts.size(); ++i) {
                QVERIFY(contacts[i].end >= contacts[i].begin);
                QVERIFY(i == 0 || contacts[i].begin >= contacts[i - 1].end);
                sum += contacts[i].end - contacts[i].begin;
            }
            QVERIFY2(std::abs(sum - impact.contactDuration) <= 1e-9 * impact.separationTime,
                     describe(scene).c_str());
            QCOMPARE(contacts.back().end, impact.separationTime);
        });
    }
};

QTEST_GUILESS_MAIN(TestWaveFronts)
#include "tst_wave_fronts.moc"
