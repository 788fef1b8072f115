// SPDX-License-Identifier: GPL-3.0-or-later
// Traits of a blow that are known before it is solved.
#include <QTest>

#include "core/model/blow_traits.h"
#include "core/wave/problem.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

class TestBlowTraits : public QObject {
    Q_OBJECT

  private slots:
    void whatFollowsFromGroupsIsTheProblemOfItsGroups();
    void onlyBlowsOnARodArePeriodicInTheGap();
};

void TestBlowTraits::whatFollowsFromGroupsIsTheProblemOfItsGroups() {
    for (const Example& example : builtInExamples()) {
        const Scenario scenario = parseScenario(example.text, example.name).scenario;
        if (!isFollowedByEvents(scenario)) continue;
        Problem ofGroups = problemOf(scenario);
        setGroups(ofGroups, groupsOf(scenario));
        QCOMPARE(ofGroups, problemOf(scenario));
    }
}

void TestBlowTraits::onlyBlowsOnARodArePeriodicInTheGap() {
    for (const Example& example : builtInExamples()) {
        const Scenario scenario = parseScenario(example.text, example.name).scenario;
        QCOMPARE(gapPeriod(scenario).has_value(), rodRefusal(problemOf(scenario)).empty());
        QCOMPARE(isFollowedByEvents(scenario), rodRefusal(problemOf(scenario)).empty());
        QCOMPARE(hasSections(scenario), !rodRefusal(problemOf(scenario)).empty());
    }
}

QTEST_GUILESS_MAIN(TestBlowTraits)
#include "tst_blow_traits.moc"
