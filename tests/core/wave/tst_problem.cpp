// SPDX-License-Identifier: GPL-3.0-or-later
// Problems of the solvers: made once from a scenario, equal where the blows are.
#include <QTest>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/wave/problem.h"

using namespace drillwave;

class TestProblem : public QObject {
    Q_OBJECT

  private slots:
    void aProblemIsTheHammerForceAndTheGroups_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("dimensional");
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::exponential, PulseShape::piston,
                                       PulseShape::table, PulseShape::rigidBody})
            for (const bool dimensional : {true, false})
                QTest::addRow("%s, %s", name(shape).data(), dimensional ? "physical" : "groups")
                    << static_cast<int>(shape) << dimensional;
    }

    void aProblemIsTheHammerForceAndTheGroups() {
        QFETCH(int, shape);
        QFETCH(bool, dimensional);
        Scenario scenario;
        scenario.form = dimensional ? ScenarioForm::dimensional : ScenarioForm::dimensionless;
        scenario.groups = {0.7, 0.2, 3, 1.25};
        scenario.bitRock.gap = 1e-3;
        scenario.pulse.shape = static_cast<PulseShape>(shape);
        scenario.pulse.tablePoints = {{0, 0}, {1e-4, 3e5}, {3e-4, 1e5}, {4e-4, 0}};
        const Groups groups = groupsOf(scenario);
        const Problem problem = problemOf(scenario);
        QVERIFY(problem.force() == pulseForceOf(scenario));
        QCOMPARE(problem.law.beta, groups.beta);
        QCOMPARE(problem.law.gamma, groups.gamma);
        QCOMPARE(problem.transitTime(), groups.tau);
        QCOMPARE(problem.gap, groups.delta);
        QVERIFY(problem == problemOf(pulseForceOf(scenario), groups));
    }

    // A blow of ten times the speed is the same blow in units of its own.
    void aStrongerBlowThroughALargerGapIsTheSameProblem() {
        Scenario weak;
        weak.bitRock.gap = 0.5e-3;
        Scenario strong = weak;
        strong.pulse.impulse *= 8;
        strong.bitRock.gap *= 8;
        QVERIFY(problemOf(weak) == problemOf(strong));
    }

    void everyPartTellsProblemsApart() {
        const Problem problem = problemOf(pulseForceOf(PulseShape::rectangular), {0.5, 0.1, 10, 0.3});
        Problem other = problem;
        QVERIFY(other == problem);
        other.drive = pulseForceOf(PulseShape::halfSine);
        QVERIFY(other != problem);
        for (double* part : {&other.sections[0].transitTime, &other.law.beta, &other.law.gamma, &other.gap}) {
            other = problem;
            *part *= 1 + 1e-15;
            QVERIFY(other != problem);
        }
    }

    void theReferenceCaseBeginsInContact() {
        const Groups groups{0.5, 0.1, 10, 0.3};
        QCOMPARE(problemOf(pulseForceOf(PulseShape::rigidBody), groups).firstGap(), 0.0);
        QCOMPARE(problemOf(pulseForceOf(PulseShape::rectangular), groups).firstGap(), 0.3);
    }
};

QTEST_GUILESS_MAIN(TestProblem)
#include "tst_problem.moc"
