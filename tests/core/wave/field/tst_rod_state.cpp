// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the rod at an instant: what the hammer has given, the rock has taken and the rod has left.
#include <QTest>
#include <cmath>

#include "core/wave/field/rod_state.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const std::vector<Scene> scenes{{PulseShape::rectangular, {0.5, 0.3, 3, 0.2}},
                                {PulseShape::exponential, {2, 1, 0.8, 0}},
                                {PulseShape::rigidBody, {0.5, 0.3, 2, 0}}};

/// ∫v dm [I0] of the waves in the rod at the time t, by the midpoint rule: v = (−Np + Nn)/Z (T2), dm = Zτ dξ.
double momentumInside(const Impact& impact, double t) {
    constexpr int cells = 4000;
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
        const double xi = (i + 0.5) / cells;
        sum += WaveField(impact).velocity(xi, t);
    }
    return sum / cells * impact.roundTrip / 2;
}

}  // namespace

class RodStateTest : public QObject {
    Q_OBJECT

  private slots:
    void givenIsTakenAndLeft() {
        for (const Scene& scene : scenes) {
            const PulseForce pulse = problemOf(scene).force();
            const Impact impact = solve(scene, Detail::histories);
            for (const double t : {0.4, 3.7, 9.1, 500.25}) {
                const RodState atBit = rodState(impact, pulse, 1, t);
                QVERIFY(std::abs(atBit.normalForce + atBit.impactForce) < 1e-14);  // of the one force there
                const double given = scene.shape == PulseShape::rigidBody ? 1 : pulse.impulseUntil(t);
                QVERIFY(std::abs(atBit.impulse + atBit.momentum - given) < 1e-14);
                QCOMPARE(rodMomentum(impact, pulse, t), atBit.momentum);
            }
        }
    }

    void theMomentumIsThatOfTheWaves() {
        for (const Scene& scene : scenes) {
            const PulseForce pulse = problemOf(scene).force();
            const Impact impact = solve(scene, Detail::histories);
            // A jump within one of 4000 cells: forces of order one times τ/4000, for a handful of fronts.
            for (const double t : {0.4, 1.9, 3.7, 9.1, 20.3})
                QVERIFY2(std::abs(momentumInside(impact, t) - rodMomentum(impact, pulse, t)) < 5e-3,
                         describe(scene).c_str());
        }
    }

    void theRodLeavesWithTheRestitution() {
        for (const Scene& scene : scenes) {
            const Impact impact = solve(scene, Detail::histories);
            QVERIFY(std::abs(rodState(impact, problemOf(scene).force(), 0.5, 500).momentum + impact.cor) <
                    1e-13);
        }
    }

    void aRigidBodyBringsItsMomentum() {
        const Scene scene = scenes[2];
        QCOMPARE(rodMomentum(solve(scene, Detail::histories), problemOf(scene).force(), 0), 1.0);
        QCOMPARE(rodMomentum(problemOf(scenes[0]).force(), 0, 0), 0.0);
    }
};

QTEST_GUILESS_MAIN(RodStateTest)
#include "tst_rod_state.moc"
