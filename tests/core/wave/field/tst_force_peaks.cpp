// SPDX-License-Identifier: GPL-3.0-or-later
// How often the impact force peaks: by the closed form, and by looking at the force everywhere.
#include <QTest>

#include <algorithm>
#include <vector>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/passing_waves.h"
#include "core/wave/lattice/lattice_solver.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Maxima above 1 % on a grid of `points`, where the force turns by more than `dip` of the largest.
int peaksSeen(const Impact& impact, int points, double dip) {
    double turn = 0;
    bool rising = true;
    int peaks = 0;
    for (int i = 0; i <= points; ++i) {
        const double force = impactForce(impact, (impact.separationTime + 1) * i / points);
        if (rising ? force > turn : force < turn) turn = force;
        if (std::abs(force - turn) <= dip * impact.peakForce) continue;
        if (rising && turn > 0.01 * impact.peakForce) ++peaks;
        rising = !rising;
        turn = force;
    }
    return peaks;
}

}  // namespace

class TestForcePeaks : public QObject {
    Q_OBJECT

  private slots:
    // The two waves of the paper's closed form make a peak each.
    void aRectangularBlowOnElasticRockMakesTwo() {
        for (const double beta : {0.5, 1.0, 3.0})
            QCOMPARE(forcePeaks(solve({PulseShape::rectangular, {beta, 1, 10, 0}}, Detail::histories)), 2);
    }

    // A rigid body with no waves that come back in the contact: one swing of a spring.
    void aRodThatSpringsBackOnceMakesOne() {
        QCOMPARE(forcePeaks(solve({PulseShape::rigidBody, {5, 1, 0.5, 0}}, Detail::histories)), 1);
    }

    void peaksAreThoseThatAreSeenEverywhere() {
        // Smallest height of a peak that a grid of 200 000 points can show.
        constexpr double visible = 1e-6;
        int looked = 0, several = 0;
        for (const ReferenceCase& reference : referenceCases()) {
            const Impact impact = solve(reference.scene, Detail::histories);
            QCOMPARE(impact.outcome, Outcome::rebounded);
            const int coarse = peaksSeen(impact, 100'000, visible), fine = peaksSeen(impact, 200'000, 1e-8);
            if (coarse != fine) continue;  // one that is hardly there
            ++looked;
            several += fine > 2;
            QVERIFY2(forcePeaks(impact) == fine, describe(reference.scene).c_str());
        }
        QVERIFY2(looked >= 60, qPrintable(QString::number(looked)));
        QVERIFY(several >= 5);
    }

    // The steps of the lattice are no peaks.
    void theLatticeCountsTheSame() {
        const Problem problem = problemOf(Scene{PulseShape::rectangular, {0.5, 0.1, 10, 0}});
        const Impact exact = ExactSolver().solve(problem, Detail::histories);
        LatticeOptions options;
        options.segments = 2000;
        const Impact lattice = LatticeSolver().solve(problem, Detail::histories, options);
        QCOMPARE(forcePeaks(lattice), forcePeaks(exact));
    }
};

QTEST_GUILESS_MAIN(TestForcePeaks)
#include "tst_force_peaks.moc"
