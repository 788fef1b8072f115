// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in the rod, against the wave field looked at everywhere.
#include <QTest>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/rod_forces.h"
#include "core/wave/field/rod_instants.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

RodForces forcesOf(const Scene& scene) {
    return largestRodForces(solve(scene, Detail::histories), problemOf(scene).force());
}

/// Compressive force at a place and time.
double compressionAt(const Impact& impact, double section, double time) {
    return -WaveField(impact).positiveWave(section, time) - WaveField(impact).negativeWave(section, time);
}

/// The largest of sign·(−N) in a close neighbourhood: at a jump the largest value is there on one side only.
double nearby(const Impact& impact, double sign, const RodForce& at) {
    double most = 0;
    const double tau = impact.roundTrip / 2;
    for (const double dx : {-1e-7, 0.0, 1e-7})
        for (const double dt : {-3e-7, -1e-7, 0.0, 1e-7, 3e-7})
            most = std::max(most, sign * compressionAt(impact, std::clamp(at.section + dx, 0.0, 1.0),
                                                       at.time + dt * tau));
    return most;
}

/// The largest sum of one sign while the blow lasts, of all pairs of instants that are in the rod together.
double largestOfAllPairs(const Impact& impact, double sign) {
    const double end = recordedEndOfBlow(impact), roundTrip = impact.roundTrip;
    std::vector<Instant> all{instantBeforeFront(impact, 0)};
    forEachInstant(impact, 0, counterparts(impact, end), [&](const Instant& now) { all.push_back(now); });
    double most = 0;
    for (std::size_t i = 0; i < all.size() && all[i].time <= end + roundTrip / 2; ++i)
        for (std::size_t j = i + 1; j-- > 0;) {
            const double late = all[i].time - all[j].time - roundTrip;
            const double rounding = roundingOfTrip(all[i].time, roundTrip);
            if (late > rounding) break;
            if (std::abs(late) <= rounding && (all[i].side != Side::end || all[j].side != Side::start))
                continue;
            if (all[i].time > end && all[j].time > 2 * end - all[i].time) continue;
            most = std::max(most, sign * (all[i].incident + all[j].reflected));
        }
    return most;
}

}  // namespace

class TestRodForces : public QObject {
    Q_OBJECT

  private slots:
    void rigidRockDoublesThePulseAtTheBit() {
        // The incident force comes back on top of itself, and then from the free rear end as tension.
        const RodForces forces = forcesOf({PulseShape::halfSine, {1e6, 1, 10, 0}});
        const double peak = std::acos(-1.0) / 2;
        QVERIFY(std::abs(forces.compression.size - 2 * peak) < 1e-4);
        QVERIFY(std::abs(forces.compression.section - 1) < 1e-4);
        QVERIFY(std::abs(forces.compression.time - 10.5) < 0.02);
        QVERIFY(std::abs(forces.tension.size - peak) < 1e-4);
    }

    void wavesThatMeetAfterABlowAddUp() {
        // Stiff rock lets the first instant of a jump back as tension, the last one as twice the force: thin
        // waves of +1 and −2 that meet in the rod after the blow.
        const RodForces forces = forcesOf({PulseShape::rectangular, {1e6, 1, 10, 0}});
        QVERIFY(std::abs(forces.compressionAfter.size - 3) < 1e-9);
        QVERIFY(std::abs(forces.tensionAfter.size - 3) < 1e-9);
        // They are one t0 apart and meet half of that from an end.
        QVERIFY(std::abs(forces.compressionAfter.section - 0.05) < 1e-6);
        QVERIFY(std::abs(forces.tensionAfter.section - 0.95) < 1e-6);
        // The first meeting, as compression at the struck end, is less than a transit after the last
        // separation.
        QVERIFY2(std::abs(forces.compression.size - 3) < 1e-9,
                 qPrintable(QString::number(forces.compression.size)));
    }

    // The last period begins at a jump but for rounding: the first instant of it counts all the same.
    void aPeriodThatBeginsAtAJumpIsSeenWhole() {
        const Scene scene{PulseShape::rectangular, {1.5022634244953927, 0.3, 3.9312780479059333, 0}};
        const Impact impact = solve(scene, Detail::histories);
        const RodForces forces = largestRodForces(impact, problemOf(scene).force());
        const double begin = impact.incident.end() - impact.roundTrip;
        double least = 0, most = 0;
        for (int i = 0; i <= 100'000; ++i) {
            const double g = incidentWave(impact, begin + impact.roundTrip * i / 100'000);
            least = std::min(least, g);
            most = std::max(most, g);
        }
        QVERIFY(std::abs(forces.tensionAfter.size - (most - least)) < 2e-3);
    }

    void whatIsLeftOutIsNeverTheLargest_data() { addRodScenes(); }

    void whatIsLeftOutIsNeverTheLargest() {
        QFETCH(Scene, scene);
        const Impact impact = solve(scene, Detail::histories);
        const PulseForce hammer = problemOf(scene).force();
        const RodForces found = largestRodForces(impact, hammer);
        const double pushed = std::max(hammer.peak, largestOfAllPairs(impact, 1));
        // to the last digit: the same instants
        QVERIFY2(found.compression.size == pushed, QByteArray::number(found.compression.size - pushed));
        const double pulled = largestOfAllPairs(impact, -1);
        QVERIFY2(found.tension.size == pulled, QByteArray::number(found.tension.size - pulled));
    }

    void onlyWhatIsWantedIsLookedFor() {
        const Scene scene{PulseShape::halfSine, {0.5, 0.2, 3, 0.3}};
        const Impact impact = solve(scene, Detail::histories);
        const PulseForce hammer = problemOf(scene).force();
        const RodForces all = largestRodForces(impact, hammer);
        RodForces some = largestRodForces(impact, hammer, {false, true, false});
        QCOMPARE(some.tension, all.tension);
        QCOMPARE(some.compression, RodForce());
        QCOMPARE(some.compressionAfter, RodForce());
        some = largestRodForces(impact, hammer, {false, false, true});
        QCOMPARE(some.compressionAfter, all.compressionAfter);
        QCOMPARE(some.tensionAfter, all.tensionAfter);
        QCOMPARE(some.tension, RodForce());
    }

    /// Most of a wave is ruled out by what its pieces come to at most.
    void fewOfAllInstantsAreLookedAt() {
        const Scene scene{PulseShape::rectangular, {0.5, 0.1, 5, 0.3}};
        const Impact impact = solve(scene, Detail::histories);
        long looked = 0, instants = 0;
        largestRodForces(impact, problemOf(scene).force(), {true, true, false}, &looked);
        forEachInstant(impact, 0, {}, [&](const Instant&) { ++instants; });
        // a sixth; more than a quarter where all that touches a largest force is halved down to its parts
        QVERIFY2(looked > 0 && 5 * looked < instants, QByteArray::number(double(looked) / double(instants)));
    }

    /// Waves left out because of their bounds are smaller than the largest one.
    void noWaveIsLargerThanTheBoundOfItsSpan_data() { addRodScenes(); }

    void noWaveIsLargerThanTheBoundOfItsSpan() {
        QFETCH(Scene, scene);
        const Impact impact = solve(scene, Detail::histories);
        std::vector<WaveSpan> spans = wholePieces(impact, 0, impact.incident.end()), parts;
        for (int round = 0; round < 3; ++round, cut(impact, spans, parts), spans.swap(parts))
            for (const WaveSpan& span : spans)
                for (const double sign : {1.0, -1.0}) {
                    const SpanBound bound = boundOf(span, sign);
                    for (int i = 1; i < 16; ++i) {
                        const double begin = span.begin.time, length = span.end.time - begin;
                        const double x = begin + length * i / 16 - impact.incident.pieces()[span.piece].start;
                        const Instant now = instantIn(impact, span.piece, x, Side::inside);
                        QVERIFY(sign * now.incident <= bound.incident);
                        QVERIFY(sign * now.reflected <= bound.reflected);
                    }
                }
    }

    void everySectionAndTimeStaysBelow_data() { addRodScenes(); }

    void everySectionAndTimeStaysBelow() {
        QFETCH(Scene, scene);
        const Impact impact = solve(scene, Detail::histories);
        const RodForces found = largestRodForces(impact, problemOf(scene).force());
        const double tolerance = 2e-4 * impact.peakForce + 1e-12;
        const double blowEnd = impact.separationTime + impact.roundTrip / 2;
        const double end = timeOfRecorded(impact, impact.incident.end()) + 2 * impact.roundTrip;
        double during[2] = {0, 0}, after[2] = {0, 0};  // compression, tension
        constexpr int sections = 97, times = 4001;     // beside the fronts
        for (int i = 0; i <= sections; ++i)
            for (int j = 0; j <= times; ++j) {
                const double time = end * j / times;
                const double N = compressionAt(impact, double(i) / sections, time);
                double* most = time <= blowEnd ? during : after;
                most[0] = std::max(most[0], N);
                most[1] = std::max(most[1], -N);
            }
        QVERIFY2(during[0] <= found.compression.size + tolerance, qPrintable(QString::number(during[0])));
        QVERIFY2(during[1] <= found.tension.size + tolerance, qPrintable(QString::number(during[1])));
        QVERIFY2(after[0] <= found.compressionAfter.size + tolerance, qPrintable(QString::number(after[0])));
        QVERIFY2(after[1] <= found.tensionAfter.size + tolerance, qPrintable(QString::number(after[1])));
        for (const RodForce& force : {found.compression, found.tension})
            QVERIFY(force.time <= blowEnd + 1e-9);
        for (const RodForce& force : {found.compressionAfter, found.tensionAfter})
            QVERIFY(force.size == 0 || force.time >= blowEnd - 1e-9);
        QVERIFY(found.compression.size >= problemOf(scene).force().peak);  // at the struck end
        // and the place and time found do have it
        QVERIFY(std::abs(nearby(impact, 1, found.compression) - found.compression.size) <= tolerance);
        QVERIFY(std::abs(nearby(impact, -1, found.tension) - found.tension.size) <= tolerance);
        QVERIFY(std::abs(nearby(impact, 1, found.compressionAfter) - found.compressionAfter.size) <=
                tolerance);
        QVERIFY(std::abs(nearby(impact, -1, found.tensionAfter) - found.tensionAfter.size) <= tolerance);
    }
};

QTEST_GUILESS_MAIN(TestRodForces)
#include "tst_rod_forces.moc"
