// SPDX-License-Identifier: GPL-3.0-or-later
// The path of the bit against the law of the rock.
#include <QTest>
#include <cmath>

#include "core/blow/impact_summary.h"
#include "core/wave/field/bit_history.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const std::vector<Scene> scenes{{PulseShape::rectangular, {0.5, 0.1, 10, 0}},
                                {PulseShape::rectangular, {0.5, 1, 10, 0.4}},
                                {PulseShape::halfSine, {2, 0.3, 0.7, 1.3}},
                                {PulseShape::rectangular, {0.8, 0.5, 3, 200.25}},
                                {PulseShape::rigidBody, {0.5, 0.3, 2, 0}}};

}  // namespace

class TestBitMotion : public QObject {
    Q_OBJECT

  private slots:
    void theLastPenetrationIsTheResidualOne() {
        for (const Scene& scene : scenes) {
            const Impact impact = solve(scene, Detail::histories);
            const auto contacts = contactIntervals(impact);
            const BitState state = bitState(impact, contacts, scene.groups.delta, impact.separationTime);
            QVERIFY(state.touching);
            const double residual = summarize(impact, problemOf(scene)).residualPenetration;
            QVERIFY2(std::abs(state.penetration - residual) < 1e-12 * (1 + scene.groups.delta),
                     describe(scene).c_str());
        }
    }

    void onThePrimaryLineThePenetrationIsForceOverStiffness() {
        for (const Scene& scene : scenes) {
            const Impact impact = solve(scene, Detail::histories);
            const auto contacts = contactIntervals(impact);
            const double begin = contacts.front().begin;
            for (int i = 1; i < 20; ++i) {  // the bit still advances: nothing has been unloaded
                const double t = begin + 1e-3 * i;
                const BitState state = bitState(impact, contacts, scene.groups.delta, t);
                const double force = WaveField(impact).impactForce(t);
                QVERIFY(state.touching);
                QVERIFY2(std::abs(state.penetration - force / (2 * scene.groups.beta)) <
                             1e-12 * (1 + scene.groups.delta),
                         describe(scene).c_str());
            }
        }
    }

    void beforeTheFirstContactTheGapCloses() {
        const Scene scene = scenes[3];
        const Impact impact = solve(scene, Detail::histories);
        const auto contacts = contactIntervals(impact);
        QCOMPARE(bitState(impact, contacts, 200.25, 0).gap, 200.25);
        // A free end advances by d0 in every round trip [paper (3)].
        QCOMPARE(bitState(impact, contacts, 200.25, impact.frontArrival + 50 * impact.roundTrip).gap, 150.25);
        QVERIFY(std::abs(bitState(impact, contacts, 200.25, contacts.front().begin * (1 - 1e-15)).gap) <
                1e-10);
    }

    void apartTheGapIsTheDistanceFromTheCrater() {
        const Scene scene = scenes[0];
        const Impact impact = solve(scene, Detail::histories);
        const auto contacts = contactIntervals(impact);
        const double trips = 40;
        const BitState state =
            bitState(impact, contacts, 0, impact.separationTime + trips * impact.roundTrip);
        QVERIFY(!state.touching);
        // It leaves with e v0; v0 is one d0 in a round trip.
        QVERIFY(std::abs(state.gap - trips * impact.cor) < 1e-10);
    }
};

QTEST_GUILESS_MAIN(TestBitMotion)
#include "tst_bit_motion.moc"
