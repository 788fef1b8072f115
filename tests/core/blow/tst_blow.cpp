// SPDX-License-Identifier: GPL-3.0-or-later
// A blow holds what its parts give one by one, and the same remarks whatever was asked of it.
#include <QTest>

#include <algorithm>

#include "core/blow/blow.h"
#include "core/blow/result_alerts.h"
#include "core/wave/exact/exact_solver.h"

using namespace drillwave;

namespace {

/// A drill that bounces off the rock and overloads its rod: a remark of every kind of place.
Scenario overloadedDrill() {
    Scenario scenario;
    scenario.rod.length = 40;  // outside its usual range
    scenario.rod.yieldStrength = 100e6;
    scenario.rod.fatigueStrength = 10e6;
    scenario.drill.blowFrequency = 50;
    scenario.drill.thrust = 100;
    return scenario;
}

/// Soft rock under a rigid body: solved by expansion, without waves.
Scenario softReferenceCase() {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = PulseShape::rigidBody;
    scenario.groups = {.beta = 1e-13, .gamma = 0.5, .tau = 1, .delta = 0};
    return scenario;
}

QStringList codesOf(const std::vector<Alert>& alerts) {
    QStringList codes;
    for (const Alert& alert : alerts) codes << QString::fromUtf8(name(alert.code).data());
    return codes;
}

}  // namespace

class TestBlow : public QObject {
    Q_OBJECT

  private slots:
    void numbersBeyondDoublePrecisionAreNoResult();
    void itsPartsAreThoseOfTheSolverAndTheSummary();
    void itsAlertsAreThoseOfTheScenarioTheResultAndTheStresses();
    void theAlertsDoNotDependOnWhatWasAsked();
    void noMoreIsRecordedThanIsAsked();
    void aBlowWithoutWavesHasNoStresses();
    void anUnsolvedBlowHasTheRemarksOnItsScenarioOnly();
};

// Its force is beyond the largest double; the rest would look right.
void TestBlow::numbersBeyondDoublePrecisionAreNoResult() {
    Scenario scenario = softReferenceCase();
    scenario.groups = {.beta = 1, .gamma = 1, .tau = 5e-324, .delta = 0};
    const Blow blow = solveBlow(scenario, {}, Detail::summary);
    QVERIFY(!blow.isSolved());
    QVERIFY(blow.impact.reason.text().starts_with("its numbers are beyond the range of double precision"));
    QVERIFY(!blow.feed);
}

void TestBlow::itsPartsAreThoseOfTheSolverAndTheSummary() {
    const Scenario scenario = overloadedDrill();
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    QVERIFY(blow.isSolved());
    const Problem problem = problemOf(scenario);
    const Impact impact = ExactSolver().solve(problem, Detail::histories);
    QCOMPARE(blow.scenario, scenario);
    QCOMPARE(blow.groups, groupsOf(scenario));
    QVERIFY(blow.problem == problem);
    QCOMPARE(blow.scales, scalesOf(scenario));
    QCOMPARE(blow.impact.cor, impact.cor);
    QCOMPARE(blow.impact.events, impact.events);
    QCOMPARE(blow.summary.peakForce, impact.peakForce);
    QCOMPARE(blow.summary.energy, ledgerOf(impact, problem));
    QCOMPARE(*blow.summary.rodForces, largestRodForces(impact, problem.force()));
    QCOMPARE(*blow.feed, *feedEstimate(scenario, {impact.cor, impact.corError}));
    // [paper (9)], by hand
    QVERIFY(std::abs(blow.feed->need(ThrustCase::scenario).thrust /
                         (50 * scenario.pulse.impulse * (1 + impact.cor)) -
                     1) < 1e-15);
}

void TestBlow::itsAlertsAreThoseOfTheScenarioTheResultAndTheStresses() {
    const Scenario scenario = overloadedDrill();
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    std::vector<Alert> all = alertsFor(scenario);
    for (const Alert& alert : resultAlerts(scenario, blow.summary)) all.push_back(alert);
    for (const Alert& alert : stressAlerts(scenario, sectionStresses(scenario, *blow.summary.rodForces)))
        all.push_back(alert);
    QCOMPARE(blow.alerts, all);
    for (const char* code :
         {"outside_plausible_range", "thrust_below_needed", "stress_above_yield", "stress_above_fatigue"})
        QVERIFY2(codesOf(all).contains(code), code);
}

// The window requests histories with stresses, `run` a summary, a file of rows only e.
void TestBlow::theAlertsDoNotDependOnWhatWasAsked() {
    Scenario withoutStrength = overloadedDrill();
    withoutStrength.rod.yieldStrength.reset();
    withoutStrength.rod.fatigueStrength.reset();
    for (const Scenario& scenario : {overloadedDrill(), withoutStrength}) {
        const Blow window = solveBlow(scenario, {}, Detail::histories, {}, Stresses::wanted);
        QCOMPARE(solveBlow(scenario, {}, Detail::histories).alerts, window.alerts);
        QCOMPARE(solveBlow(scenario, {}, Detail::ledger).alerts, window.alerts);
    }
}

void TestBlow::noMoreIsRecordedThanIsAsked() {
    const Scenario scenario;
    const Blow quick = solveBlow(scenario, {}, Detail::cor);
    QVERIFY(quick.impact.events.empty());
    const Blow summary = solveBlow(scenario, {}, Detail::ledger);
    QVERIFY(!summary.impact.events.empty());
    QVERIFY(summary.impact.force.empty());
    QVERIFY(!summary.summary.rodForces);
    const Blow stresses = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
    QVERIFY(!stresses.impact.force.empty());
    QVERIFY(stresses.summary.rodForces);
}

void TestBlow::aBlowWithoutWavesHasNoStresses() {
    const Scenario scenario = softReferenceCase();
    QVERIFY(!solveBlow(scenario, {}, Detail::histories, {}, Stresses::wanted).isSolved());
    const Blow blow = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
    QVERIFY(blow.isSolved());
    QVERIFY(!blow.summary.rodForces);
    QVERIFY(std::abs(blow.summary.cor - std::sqrt(0.5)) < 1e-9);  // (T30)
}

void TestBlow::anUnsolvedBlowHasTheRemarksOnItsScenarioOnly() {
    const Scenario scenario = overloadedDrill();
    MethodSolver solver({.pieces = 1});
    const Blow blow = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::asNeeded, solver);
    QVERIFY(!blow.isSolved());
    QVERIFY(!blow.impact.reason.isEmpty());
    QCOMPARE(blow.alerts, alertsFor(scenario));
    QVERIFY(!blow.feed);
}

QTEST_GUILESS_MAIN(TestBlow)
#include "tst_blow.moc"
