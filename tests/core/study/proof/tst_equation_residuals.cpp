// SPDX-License-Identifier: GPL-3.0-or-later
// Histories put back into the equations: right ones satisfy them, wrong ones are found out.
#include <QTest>

#include "core/study/proof/equation_residuals.h"
#include "core/wave/exact/exact_solver.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

EquationResiduals residuals(const Scene& solved, const Scene& claimed) {
    return equationResiduals(solve(solved, Detail::histories), problemOf(claimed));
}

}  // namespace

class TestEquationResiduals : public QObject {
    Q_OBJECT

  private slots:
    void exactHistoriesSatisfyTheEquations_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("paper Fig. 4 (a)") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0}};
        QTest::newRow("paper Fig. 4 (b)") << Scene{PulseShape::rectangular, {0.5, 0.1, 10, 0}};
        QTest::newRow("several contacts") << Scene{PulseShape::halfSine, {0.05, 0.05, 3.3, 0.9}};
        QTest::newRow("hammer longer than a round trip")
            << Scene{PulseShape::triangular, {0.7, 0.3, 0.21, 0.4}};
        QTest::newRow("gap of a thousand periods") << Scene{PulseShape::trapezoid, {0.7, 0.3, 4, 1000.3}};
        QTest::newRow("drift of six periods") << Scene{
            PulseShape::triangular, {8.608803593025662, 0.001445050398879033, 0.10597910724628155, 0}};
        QTest::newRow("reference case") << Scene{PulseShape::rigidBody, {0.5, 0.1, 2, 0}};
        QTest::newRow("stiff") << Scene{PulseShape::exponential, {1e5, 0.01, 3, 0.3}};
    }

    void exactHistoriesSatisfyTheEquations() {
        QFETCH(Scene, scene);
        const EquationResiduals found = residuals(scene, scene);
        QVERIFY(found.points > 50);
        // a look-up 2τ earlier rounds times of up to some hundred
        QVERIFY2(found.wave < 1e-12, qPrintable(QString::number(found.wave)));
        QVERIFY2(found.rate < 1e-13, qPrintable(QString::number(found.rate)));
        QVERIFY2(found.law < 1e-13, qPrintable(QString::number(found.law)));
        QVERIFY(found.leastForce > -1e-14);
    }

    // Stiff rock, a rod shorter than the blow: the force stays at its peak over several pieces, where events
    // repeat on the spot by rounding. Once the branch had been let go there, it was never looked at again,
    // and the force then rose above its peak along the unloading line.
    void aForceThatStaysAtItsPeakLeavesItOnThePrimaryLine_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("τ = 0.104") << Scene{
            PulseShape::triangular, {252.36640118686242, 0.011886933388099897, 0.10405065429544774, 0}};
        QTest::newRow("τ = 0.068") << Scene{
            PulseShape::triangular, {299.3291238984724, 0.0053093446719397449, 0.067629999998518819, 0}};
        QTest::newRow("τ = 0.082") << Scene{
            PulseShape::triangular, {281.64143481306667, 0.00075373932489213892, 0.082082862767587694, 0}};
    }

    void aForceThatStaysAtItsPeakLeavesItOnThePrimaryLine() {
        QFETCH(Scene, scene);
        const EquationResiduals found = residuals(scene, scene);
        QVERIFY2(found.law < 1e-13, qPrintable(QString::number(found.law)));
        QVERIFY2(found.rate < 1e-13, qPrintable(QString::number(found.rate)));
        const Impact exact = solve(scene);
        const Impact extended = solveInExtendedPrecision(problemOf(scene));
        QVERIFY(std::abs(exact.cor - extended.cor) <= exact.corError);
    }

    // Three lines, contacts that stop on each of them, and the one line that differs from the others.
    void cornersAreOfTheEquations() {
        Problem problem = problemOf({PulseShape::halfSine, {0.6, 0.2, 3.3, 0.4}});
        problem.law.corners = {{0.15, 0.4}, {0.4, 2}};
        ExactSolver solver;
        const Impact impact = solver.solve(problem, Detail::histories);
        QVERIFY(impact.peakForce > 0.4);
        const EquationResiduals found = equationResiduals(impact, problem);
        QVERIFY2(found.rate < 1e-13, qPrintable(QString::number(found.rate)));
        QVERIFY2(found.law < 1e-13, qPrintable(QString::number(found.law)));
        problem.law.corners[1].slope = 2.001;
        const EquationResiduals other = equationResiduals(impact, problem);
        QVERIFY(other.rate > 1e-6 && other.law > 1e-6);
    }

    void anotherRockIsFoundOut() {
        const Scene solved{PulseShape::rectangular, {0.5, 0.1, 10, 0.3}};
        // as if an event had been missed or a rate been wrong
        for (const Groups& groups : {Groups{0.5001, 0.1, 10, 0.3}, Groups{0.5, 0.1001, 10, 0.3}}) {
            const EquationResiduals found = residuals(solved, {solved.shape, groups});
            QVERIFY(found.rate > 1e-6 && found.law > 1e-6);
            QVERIFY(found.wave < 1e-12);  // the waves know nothing of the rock
        }
        const EquationResiduals gap = residuals(solved, {solved.shape, {0.5, 0.1, 10, 0.3001}});
        QVERIFY(gap.law > 1e-6 && gap.wave < 1e-12);
    }

    void anotherHammerIsFoundOut() {
        const Groups groups{0.5, 0.1, 10, 0};
        const EquationResiduals found =
            residuals({PulseShape::triangular, groups}, {PulseShape::halfSine, groups});
        QVERIFY(found.wave > 1e-3 && found.rate < 1e-13 && found.law < 1e-13);
    }
};

QTEST_GUILESS_MAIN(TestEquationResiduals)
#include "tst_equation_residuals.moc"
