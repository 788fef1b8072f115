// SPDX-License-Identifier: GPL-3.0-or-later
// One place that calls every solver.
#include <QTest>

#include "core/blow/method.h"
#include "core/wave/closed/closed_form.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

class TestMethod : public QObject {
    Q_OBJECT

  private slots:
    void namesReadBack() {
        for (const std::string_view text : methodNames()) {
            const std::optional<Method> method = findMethod(text);
            QVERIFY(method && name(*method) == text);
        }
        QVERIFY(!findMethod("guess"));
        QVERIFY(MethodChoice{}.method == Method::exact);
    }

    void everyMethodIsTheSolverOfItsName() {
        const Scene scene{PulseShape::rectangular, {0.5, 1, 10, 0}};
        const Problem problem = problemOf(scene);
        MethodSolver solver;
        LatticeSolver lattice;
        const LatticeOptions options{.segments = 500};
        // twice, because the workspace is kept
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(solver.solve(problem, Detail::cor).cor, solve(scene).cor);
            QCOMPARE(solver.solve(problem, Detail::cor, {Method::lattice, options}).cor,
                     lattice.solve(problem, Detail::cor, options).cor);
            QCOMPARE(solver.solve(problem, Detail::cor, {Method::closedForm, {}}).cor,
                     closedFormRestitution(0.5));
        }
    }

    void onlyTheClosedFormRefusesBlows() {
        const Scene scene{PulseShape::rectangular, {0.5, 0.1, 10, 0}};
        const Problem problem = problemOf(scene);
        QVERIFY(methodRefusal(Method::exact, problem).isEmpty());
        QVERIFY(methodRefusal(Method::lattice, problem).isEmpty());
        const std::string refusal = methodRefusal(Method::closedForm, problem).text();
        QVERIFY(!refusal.empty());
        const Impact impact = MethodSolver().solve(problem, Detail::cor, {Method::closedForm, {}});
        QCOMPARE(impact.outcome, Outcome::notSolved);
        QCOMPARE(impact.reason.text(), refusal);
    }

    void everySolverTakesAProblemOrRefusesIt() {
        const Problem rod = problemOf(Scene{PulseShape::rectangular, {0.5, 1, 10, 0}});
        Problem two = rod, heavy = rod, struckRod = rod;
        two.sections.push_back({.transitTime = 1});
        heavy.sections[0].massAfter = 0.1;
        struckRod.drive = ElasticHammer{};
        struckRod.sections.insert(struckRod.sections.begin(), {.transitTime = 0.5});
        MethodSolver solver;
        for (const MethodChoice& choice : {MethodChoice{}, MethodChoice{Method::lattice, {.segments = 10}},
                                           MethodChoice{Method::closedForm, {}}})
            for (const Problem& other : {two, heavy, struckRod}) {
                const Impact impact = solver.solve(other, Detail::cor, choice);
                QCOMPARE(impact.outcome, Outcome::notSolved);
                QVERIFY(impact.reason.text() == rodRefusal(other) && !impact.reason.isEmpty());
                QCOMPARE(impact.hindrance, Hindrance::other);
            }
        QVERIFY(rodRefusal(rod).empty() && networkRefusal(struckRod).empty());
        const Problem arriving = problemOf(Scene{PulseShape::rigidBody, {0.5, 1, 10, 0}});
        const Impact refused = NetworkSolver().solve(arriving, {});
        QVERIFY(refused.outcome == Outcome::notSolved && refused.reason.text() == networkRefusal(arriving));
        QVERIFY(!refused.reason.isEmpty() && rodRefusal(arriving).empty());
    }
};

QTEST_GUILESS_MAIN(TestMethod)
#include "tst_method.moc"
