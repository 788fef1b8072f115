// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of a strain gauge at a section: the sum of all waves, against the wave field.
#include <QTest>

#include "core/wave/field/wave_curves.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// The straight line through the points beside t, which must not be at a jump.
double chordAt(const SampledCurve& curve, double t) {
    const auto behind = std::ranges::upper_bound(curve.time, t) - curve.time.begin();
    if (behind == 0 || behind == std::ssize(curve.time)) return std::numeric_limits<double>::quiet_NaN();
    const auto i = static_cast<std::size_t>(behind);
    const double share = (t - curve.time[i - 1]) / (curve.time[i] - curve.time[i - 1]);
    return std::lerp(curve.value[i - 1], curve.value[i], share);
}

SectionForce forceOf(const Impact& impact, double xi, double end) {
    return sectionForce(impact, xi, sectionWaves(impact, xi, 4), end);
}

/// At times of no particular kind: a front passes none of them.
constexpr double anyStep = 0.0618033988749895;

}  // namespace

class TestSectionForce : public QObject {
    Q_OBJECT

  private slots:
    // The rounding of a time after so many round trips is larger than what is no part of a curve.
    void aDriftOverMillionsOfRoundTripsIsCutShort() {
        for (const double tau : {3.0, 3.1, 0.7}) {
            const Impact impact =
                solve({PulseShape::rectangular, {0.5, 1, tau, 3e6 + 0.25}}, Detail::histories);
            QVERIFY(impact.separationTime > 1e6 * impact.roundTrip);
            for (const double xi : {0.0, 0.5, 0.9999}) {
                const SectionForce found = forceOf(impact, xi, 1.1 * impact.separationTime);
                QVERIFY(found.force.time.size() > 10'000);
                QVERIFY(found.force.time.size() < 1'000'000);
                QVERIFY(std::ranges::is_sorted(found.force.time));
            }
        }
    }

    void itIsTheForceOfTheField_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("paper Fig. 4 (a)") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0}};
        QTest::newRow("short rod") << Scene{PulseShape::halfSine, {0.8, 0.2, 0.3, 0.3}};
        QTest::newRow("piston") << Scene{PulseShape::piston, {5, 0.2, 1.7, 0}};
        QTest::newRow("reference case") << Scene{PulseShape::rigidBody, {0.5, 0.1, 2, 0}};
        QTest::newRow("gap of ten periods") << Scene{PulseShape::rectangular, {0.7, 0.3, 4, 10.3}};
    }

    void itIsTheForceOfTheField() {
        QFETCH(Scene, scene);
        const Impact impact = solve(scene, Detail::histories);
        const double end = std::max(1.1 * impact.separationTime, 3 * impact.roundTrip);
        const WaveField field(impact);
        for (const double xi : {0.0, 0.3, 0.5, 1.0}) {
            const SectionForce found = forceOf(impact, xi, end);
            QVERIFY(std::ranges::is_sorted(found.force.time));
            QVERIFY(found.force.time.front() <= 0);
            QVERIFY(std::abs(found.force.time.back() - end) < 1e-9 * end);
            // Chords follow each wave to about 1e-4 of its pieces' size.
            const double tolerance = 5e-4 * std::max(1.0, problemOf(scene).force().peak);
            for (double t = anyStep; t < end; t += anyStep)
                QVERIFY2(std::abs(chordAt(found.force, t) - field.force(xi, t)) < tolerance,
                         qPrintable(QString("x/L %1, t %2: %3 for %4")
                                        .arg(xi)
                                        .arg(t)
                                        .arg(chordAt(found.force, t))
                                        .arg(field.force(xi, t))));
        }
    }

    void laterWavesGoOnWhereTheFirstEnd() {
        const Impact impact = solve({PulseShape::halfSine, {0.8, 0.2, 0.3, 0.3}}, Detail::histories);
        const double xi = 0.4, end = impact.separationTime;
        const SectionForce found = forceOf(impact, xi, end);
        const std::vector<SectionWave> first = sectionWaves(impact, xi, 4);
        const WaveField field(impact);
        for (const auto& [later, before, isToBit] :
             {std::tuple(&found.toBit, &first[2], true), std::tuple(&found.fromBit, &first[3], false)}) {
            QVERIFY(later->time.size() > 10);
            QVERIFY(std::abs(later->time.front() - before->curve.time.back()) < 1e-12);
            QVERIFY(later->time.back() <= end + 1e-12);
            for (double t = later->time.front() + anyStep; t < end; t += anyStep)
                QVERIFY(std::abs(chordAt(*later, t) -
                                 (isToBit ? field.positiveWave(xi, t) : field.negativeWave(xi, t))) < 1e-3);
        }
    }

    void itsImpulseIsTheIntegral() {
        const Impact impact = solve({PulseShape::halfSine, {0.8, 0.2, 2, 0.3}}, Detail::histories);
        for (const double xi : {0.0, 0.37, 1.0}) {
            double sum = 0;
            const double from = 1, to = 9;
            constexpr int steps = 20000;
            const double step = (to - from) / steps;
            for (int i = 0; i < steps; ++i)
                sum += WaveField(impact).force(xi, from + (i + 0.5) * step) * step;
            // The midpoint rule across the kinks of a half sine.
            QVERIFY(std::abs(sectionImpulse(impact, xi, to) - sectionImpulse(impact, xi, from) - sum) < 1e-6);
        }
    }

    void aLongDriftIsToldInBoundedMemory() {
        // Drifts for thousands of round trips before it hits again.
        const Impact impact = solve({PulseShape::rectangular, {0.5, 0.1, 0.5, 2e5}}, Detail::histories);
        QVERIFY(impact.separationTime > 1e5 * impact.roundTrip);
        const SectionForce found = forceOf(impact, 0.5, impact.separationTime);
        QVERIFY(found.toBit.time.size() < 600'000);
        QVERIFY(found.force.time.size() < 1'500'000);
    }
};

QTEST_GUILESS_MAIN(TestSectionForce)
#include "tst_section_force.moc"
