// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of the waves in a string: against the uniform rod, its joints, its peaks and its sums.
#include <QTest>

#include "core/wave/field/wave_field.h"
#include "core/wave/network/network_solver.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/problem.h"
#include "tests/support/network_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

class TestStringWaves : public QObject {
    Q_OBJECT

  private slots:
    void stringOfOneRodHasTheWavesOfTheUniformRod_data() {
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        QTest::addColumn<double>("tau");
        QTest::addColumn<double>("delta");
        QTest::newRow("paper, Fig. 3") << 0.5 << 0.1 << 10.0 << 0.0;
        QTest::newRow("with a gap") << 1.0 << 0.4 << 5.0 << 0.3;
        QTest::newRow("elastic") << 0.5 << 1.0 << 3.0 << 0.0;
    }

    void stringOfOneRodHasTheWavesOfTheUniformRod() {
        QFETCH(double, beta);
        QFETCH(double, gamma);
        QFETCH(double, tau);
        QFETCH(double, delta);
        const Groups groups{beta, gamma, tau, delta};
        const Impact exact = solve({PulseShape::rectangular, groups}, Detail::histories);
        const Problem problem = rodAsString(groups, exact.separationTime + tau);
        const Impact impact = solvedWithWaves(problem);
        QVERIFY(impact.waves);
        const StringWaves& waves = *impact.waves;
        const WaveField field(exact);
        std::vector<double> jumps;  // of waves at one of the ends
        for (int trip = 0; trip * tau <= *problem.endTime; ++trip)
            for (const double front : {0.0, 1.0}) jumps.push_back(trip * tau + front);
        int compared = 0;
        const auto compareAt = [&](double t) {
            for (const double xi : {0.0, 0.25, 0.5, 1.0}) {
                const double expected = -field.force(xi, t);
                const double force = waves.force(1, xi, t);
                QVERIFY2(std::abs(force - expected) < 1e-9, QString("N at xi %1, t %2: %3, not %4")
                                                                .arg(xi)
                                                                .arg(t, 0, 'g', 15)
                                                                .arg(force, 0, 'g', 15)
                                                                .arg(expected, 0, 'g', 15)
                                                                .toUtf8());
                QVERIFY(std::abs(waves.velocity(1, xi, t) - field.velocity(xi, t)) < 1e-9);
            }
            QVERIFY(std::abs(waves.bitForce()(t) - field.impactForce(t)) < 1e-9);
            ++compared;
        };
        Chance chance(3);
        for (int i = 0; i < 2000; ++i) compareAt(*problem.endTime * chance.fraction());
        for (const double jump : jumps)
            for (const double beside : {-1e-7, 1e-7})
                if (jump + beside > 0 && jump + beside < *problem.endTime) compareAt(jump + beside);
        for (const ImpactEvent& event : exact.events)
            for (const double beside : {-1e-7, 1e-7}) compareAt(event.time + beside);
        QVERIFY(compared > 2020);
    }

    void curvesHoldWhatTheBlowStates_data() {
        QTest::addColumn<QString>("id");
        int number = 0;
        for (const NetworkCase& scene : networkCases())
            if (isChosen(number++, 5)) QTest::newRow(scene.id.c_str()) << QString::fromStdString(scene.id);
    }

    void curvesHoldWhatTheBlowStates() {
        QFETCH(QString, id);
        const Problem& problem = caseCalled(id.toStdString()).problem;
        const Impact impact = solvedWithWaves(problem);
        const double end = impact.endTime;
        QVERIFY(impact.waves);
        // thousands of parts to a cell are too many to be kept: the waves are of a coarser string
        QCOMPARE(impact.wavesDifference.has_value(), id.startsWith("uniform_stiff"));
        if (impact.wavesDifference) return;
        const StringWaves& waves = *impact.waves;
        QCOMPARE(waves.end(), end);
        // moments are exact, so that sums of thousands of cells differ by rounding; where the waves of the
        // better of two runs are too many, by what that one is better
        const double tolerance = 1e-9 + impact.efficiencyError + impact.corError;
        QVERIFY(std::abs(waves.bitForce().integral(end) - impact.impulse) < tolerance);
        QVERIFY(std::abs(waves.faceForce().integral(end) - impact.faceImpulse) < tolerance);
        // where bit and rock first meet it has come as far as the gap
        if (impact.firstContactTime >= 0 && impact.firstContactTime < end)
            QVERIFY(std::abs(waves.bitVelocity().integral(impact.firstContactTime) - problem.distance()) <
                    2e-6);  // within a cell
    }

    void theRockIsFeltFromContactToSeparation() {
        int contacts = 0, separations = 0;
        for (const char* id :
             {"uniform_bilinear", "uniform_gap", "mirror_hammer", "t38_soft", "other_material"}) {
            const Impact impact = solvedWithWaves(caseCalled(id).problem);
            QVERIFY(impact.waves);
            const auto force = [&](double t) { return impact.waves->bitForce()(t); };
            constexpr double beside = 1e-5;  // its force is less than its slope, some 10, times that
            for (const ImpactEvent& event : impact.events) {
                if (event.kind == ContactEvent::contact) {
                    QVERIFY(std::abs(force(event.time - beside)) < 1e-15);
                    QVERIFY(force(event.time + beside) > 0 && force(event.time + beside) < 1e-3);
                    ++contacts;
                } else if (event.kind == ContactEvent::separation) {
                    QVERIFY(force(event.time - beside) > 0 && force(event.time - beside) < 1e-3);
                    QVERIFY(std::abs(force(event.time + beside)) < 1e-15);
                    ++separations;
                }
            }
        }
        QVERIFY(contacts >= 7 && separations >= 7);
    }

    void forceIsTheSameOnBothSidesOfAJoint() {
        const Problem& problem = caseCalled("t38_medium").problem;
        const Impact impact = solvedWithWaves(problem);
        QVERIFY(impact.waves);
        Chance chance(7);
        int compared = 0;
        for (std::size_t j = 0; j + 1 < problem.sections.size(); ++j) {
            if (problem.sections[j].massAfter > 0 || problem.sections[j].loss > 0) continue;
            for (int i = 0; i < 500; ++i, ++compared) {
                const double t = impact.endTime * chance.fraction();
                QVERIFY(std::abs(impact.waves->force(j, 1, t) - impact.waves->force(j + 1, 0, t)) < 1e-12);
                if (j + 1 != problem.hammerSections())
                    QVERIFY(std::abs(impact.waves->velocity(j, 1, t) - impact.waves->velocity(j + 1, 0, t)) <
                            1e-12);
            }
        }
        QVERIFY(compared > 3000);
    }

    void largestForcesOfSectionsAreThereAndNowhereMore() {
        for (const char* id : {"t38_soft", "very_soft_rock", "uniform_split"}) {
            const Impact impact = solvedWithWaves(caseCalled(id).problem);
            QVERIFY(impact.waves);
            Chance chance(9);
            for (std::size_t j = 0; j < impact.sections.size(); ++j) {
                const auto read = [&](double xi, double t) {
                    double down = -INFINITY, up = -INFINITY;  // waves that jump may meet in their jumps
                    for (const TimeSide side : {TimeSide::before, TimeSide::after}) {
                        down = std::max(down, impact.waves->down(j, xi, t, side));
                        up = std::max(up, impact.waves->up(j, xi, t, side));
                    }
                    return down + up;
                };
                const SectionForces& told = impact.sections[j];
                for (const SectionPeak& peak : {told.compression, told.compressionAfter})
                    if (peak.force > 0) QVERIFY(read(peak.place, peak.time) > peak.force - 1e-8);
                for (int i = 0; i < 3000; ++i) {
                    const double xi = chance.fraction(), t = impact.endTime * chance.fraction();
                    const SectionPeak& most =
                        t <= impact.endOfBlow ? told.compression : told.compressionAfter;
                    QVERIFY(read(xi, t) < most.force + 1e-8);
                }
            }
        }
    }

    void curvesAreSmoothBetweenTheirPieceTimes() {
        const Impact impact = solvedWithWaves(caseCalled("t38_medium").problem);
        QVERIFY(impact.waves);
        const StringWaves& waves = *impact.waves;
        const std::vector<double> times = waves.pieceTimes(4, 0.3);
        QVERIFY(std::is_sorted(times.begin(), times.end()));
        QCOMPARE(times.front(), 0.0);
        QCOMPARE(times.back(), waves.end());
        double sum = 0;
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const double a = times[i], b = times[i + 1];
            const double before = waves.force(4, 0.3, a), behind = waves.force(4, 0.3, b, TimeSide::before);
            sum +=
                (b - a) * (before + 4 * waves.force(4, 0.3, (a + b) / 2) + behind) / 6;  // exact for cubics
        }
        const double impulse = waves.downImpulse(4, 0.3, waves.end()) + waves.upImpulse(4, 0.3, waves.end());
        QVERIFY(std::abs(sum - impulse) < 1e-11);
    }

    void wavesThatAreTooManyAreThoseOfACoarserString() {
        Problem problem = caseCalled("t38_medium").problem;
        problem.endTime = 40 * *problem.endTime;
        const Impact impact = solvedWithWaves(problem);
        QCOMPARE(impact.outcome, Outcome::endTime);
        QVERIFY(impact.waves);
        QVERIFY(impact.wavesDifference);
        // cells as long as 40 blows need make the steep parts less steep
        QVERIFY2(*impact.wavesDifference < 0.03, QByteArray::number(*impact.wavesDifference));
        QVERIFY(std::abs(impact.waves->end() / impact.endTime - 1) < 1e-3);
        NetworkSettings whole;
        whole.wants.histories = true;
        whole.roundsForWaves = false;
        QVERIFY(!solveNetwork(problem, whole).waves);
    }

    void withoutBeingAskedForNoneAreKept() {
        QVERIFY(!solveNetwork(caseCalled("t38_medium").problem, {}).waves);
    }
};

QTEST_GUILESS_MAIN(TestStringWaves)
#include "tst_string_waves.moc"
