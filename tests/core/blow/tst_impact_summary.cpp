// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a solved blow: balances and limits.
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/blow/impact_summary.h"
#include "core/blow/result_alerts.h"
#include "core/blow/string_blow.h"
#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/report/alert_words.h"
#include "core/wave/closed/closed_form.h"
#include "core/wave/exact/exact_solver.h"

using namespace drillwave;

namespace {

struct Case {
    PulseShape shape = PulseShape::rectangular;
    Groups groups;
};

Scenario scenarioOf(const Case& wanted) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = wanted.groups;
    scenario.pulse.shape = wanted.shape;
    return scenario;
}

ImpactSummary summaryOf(const Scenario& scenario) {
    const Problem problem = problemOf(scenario);
    return summarize(ExactSolver().solve(problem, Detail::ledger), problem);
}

/// The alert of that code; nullptr when there is none.
const Alert* find(const std::vector<Alert>& alerts, AlertCode code) {
    const auto found = std::ranges::find(alerts, code, &Alert::code);
    return found == alerts.end() ? nullptr : &*found;
}

/// A double to be equal but for the rounding of a few operations.
bool close(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

}  // namespace

class TestImpactSummary : public QObject {
    Q_OBJECT

  private slots:
    void energyAndMomentumBalance_data();
    void energyAndMomentumBalance();
    void anElasticSpringKeepsNoEnergy();
    void theUnloadingShareOfTheWorkIsReturned();
    void aRigidBodyBringsTheWorkOfItsOwnVelocity();
    void workRatioOfARectangularBlowIsTwiceTau();
    void penetrationFollowsTheBilinearLaw();
    void alertsFollowFromTheResult();
    void severalContactsAreCounted();
    void theClosedFormIsQuestionedWhereOneWouldExpectIt_data();
    void theClosedFormIsQuestionedWhereOneWouldExpectIt();
    void aRodIsWarnedOfStressAboveItsYieldStrength();
    void aRodIsWarnedOfTensionAboveItsFatigueStrength();
};

void TestImpactSummary::energyAndMomentumBalance_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("beta");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("tau");
    QTest::addColumn<double>("delta");
    const auto add = [](const char* name, PulseShape shape, Groups g) {
        QTest::newRow(name) << static_cast<int>(shape) << g.beta << g.gamma << g.tau << g.delta;
    };
    add("paper Fig. 4 (a)", PulseShape::rectangular, {0.5, 1, 10, 0});
    add("paper Fig. 4 (b)", PulseShape::rectangular, {0.5, 0.1, 10, 0});
    add("paper Fig. 8, minimum", PulseShape::rectangular, {0.5, 1, 10, 0.521});
    add("reference case", PulseShape::rigidBody, {0.5, 0.1, 1, 0});
    add("hammer pushing during reflections", PulseShape::halfSine, {0.7, 0.3, 0.2, 0.1});
    add("staircase of a piston", PulseShape::piston, {0.7, 0.3, 4, 0.1});
    add("soft", PulseShape::triangular, {0.01, 0.1, 5, 0});
    add("stiff", PulseShape::trapezoid, {1000, 0.1, 5, 0.3});
}

void TestImpactSummary::energyAndMomentumBalance() {
    QFETCH(int, shape);
    QFETCH(double, beta);
    QFETCH(double, gamma);
    QFETCH(double, tau);
    QFETCH(double, delta);
    const ImpactSummary s =
        summaryOf(scenarioOf({static_cast<PulseShape>(shape), {beta, gamma, tau, delta}}));
    // The accuracy that the solver promises for whole balances.
    QVERIFY(std::abs(s.momentumResidual) < 1e-11);
    QVERIFY(std::abs(s.energy.residual) < 1e-11);
    QVERIFY(close(s.energy.rockWork + s.energy.reboundEnergy + s.energy.residualWaveEnergy,
                  1 + s.energy.residual, 1e-14));
    QVERIFY(close(s.impulse, 1 + s.cor, 1e-15));
    QVERIFY(s.energy.rockWork > -1e-11 && s.energy.residualWaveEnergy > -1e-11);
}

void TestImpactSummary::anElasticSpringKeepsNoEnergy() {
    const ImpactSummary s = summaryOf(scenarioOf({PulseShape::rectangular, {0.5, 1, 10, 0.3}}));
    QVERIFY(std::abs(s.energy.rockWork) < 1e-11);
    QCOMPARE(s.residualPenetration, 0.0);
}

// With one loading and one unloading the rock keeps (1 − γ) of the largest work Fm²/(2k) (paper, section 2).
void TestImpactSummary::theUnloadingShareOfTheWorkIsReturned() {
    const Groups groups{2.6, 0.25, 1, 0};
    const Scenario scenario = scenarioOf({PulseShape::rigidBody, groups});
    const ImpactSummary s = summaryOf(scenario);
    // Energies in I0²/(Z t0): Fm²/(2β) there; W = W0 = 1/(2τ).
    const double largestWork = s.peakForce * s.peakForce / (2 * groups.beta);
    QVERIFY(close(s.energy.rockWork, (1 - groups.gamma) * largestWork * 2 * groups.tau, 1e-12));
}

void TestImpactSummary::aRigidBodyBringsTheWorkOfItsOwnVelocity() {
    for (const double tau : {0.3, 1.0, 7.0}) {
        const ImpactSummary s = summaryOf(scenarioOf({PulseShape::rigidBody, {0.5, 0.4, tau, 0}}));
        QVERIFY(close(s.workRatio, 1, 1e-14));
        // m v²/2 after over m v0²/2 before.
        QVERIFY(close(s.energy.reboundEnergy, s.cor * s.cor, 1e-13));
    }
}

// Equation (2): W = 2τ W0 when the pulse is over before its reflection is back.
void TestImpactSummary::workRatioOfARectangularBlowIsTwiceTau() {
    for (const double tau : {0.5, 3.0, 10.0})
        QVERIFY(close(summaryOf(scenarioOf({PulseShape::rectangular, {0.5, 1, tau, 0}})).workRatio, 2 * tau,
                      1e-13));
}

void TestImpactSummary::penetrationFollowsTheBilinearLaw() {
    const Groups groups{0.8, 0.3, 4, 0};
    const ImpactSummary s = summaryOf(scenarioOf({PulseShape::rectangular, groups}));
    QCOMPARE(s.maxPenetration, s.peakForce / (2 * groups.beta));
    QCOMPARE(s.residualPenetration, (1 - groups.gamma) * s.maxPenetration);
    // In SI: U = F/k, without any of the scales.
    Scenario rod;
    const ImpactSummary r = summaryOf(rod);
    const Scales scales = scalesOf(rod);
    QVERIFY(close(r.maxPenetration * scales.penetration * rod.bitRock.stiffness, r.peakForce * scales.force,
                  1e-14));
}

void TestImpactSummary::alertsFollowFromTheResult() {
    const auto codes = [](const Scenario& scenario, double cor, double corError) {
        ImpactSummary summary;
        summary.cor = cor;
        summary.corError = corError;
        QStringList list;
        for (const Alert& alert : resultAlerts(scenario, summary))
            list << QString::fromUtf8(name(alert.code).data());
        return list.join(' ');
    };
    Scenario drill;
    drill.drill.blowFrequency = 60;
    drill.drill.thrust = 60 * 51 * 1.4 - 1;
    QCOMPARE(codes(drill, 0.4, 1e-14), QString("thrust_below_needed"));
    drill.drill.thrust = 60 * 51 * 1.4 + 1;
    QCOMPARE(codes(drill, 0.4, 1e-14), QString());
    drill.drill = {};
    QCOMPARE(codes(drill, 1.2, 1e-14), QString("super_rebound"));
    // Rigid rock gives e = 1 up to rounding: no super rebound.
    QCOMPARE(codes(drill, 1 + 1e-15, 1e-14), QString());
    QCOMPARE(codes(drill, 0.5, 1e-8), QString("reduced_accuracy"));
    // no digit that is shown has the one error, each has the other
    for (const double error : {4e-9, 1e-3}) {
        ImpactSummary summary;
        summary.cor = 0.5;
        summary.corError = error;
        QCOMPARE(resultAlerts(drill, summary).front().level,
                 error < 1e-4 ? AlertLevel::information : AlertLevel::warning);
    }
}

void TestImpactSummary::severalContactsAreCounted() {
    const Scenario scenario = scenarioOf({PulseShape::halfSine, {0.05, 0.05, 3.3, 0.9}});
    const ImpactSummary summary = summaryOf(scenario);
    QVERIFY(summary.contacts > 1);
    const std::vector<Alert> alerts = resultAlerts(scenario, summary);
    const Alert* alert = find(alerts, AlertCode::severalContacts);
    QVERIFY(alert);
    QCOMPARE(alert->argument("contacts").value, double(summary.contacts));
    const Scenario once = scenarioOf({PulseShape::rectangular, {0.5, 1, 10, 0}});
    QVERIFY(!find(resultAlerts(once, summaryOf(once)), AlertCode::severalContacts));
}

void TestImpactSummary::theClosedFormIsQuestionedWhereOneWouldExpectIt_data() {
    QTest::addColumn<Case>("wanted");
    QTest::addColumn<QString>("parameter");
    QTest::newRow("holds") << Case{PulseShape::rectangular, {0.5, 1, 10, 0}} << "";
    QTest::newRow("holds after a whole gap") << Case{PulseShape::rectangular, {0.5, 1, 10, 2}} << "";
    QTest::newRow("gap") << Case{PulseShape::rectangular, {0.5, 1, 10, 0.3}} << "delta";
    QTest::newRow("long blow") << Case{PulseShape::rectangular, {0.5, 1, 0.4, 0}} << "tau";
    QTest::newRow("overlap") << Case{PulseShape::rectangular, {0.02, 1, 2, 0}} << "beta";
    QTest::newRow("not for this pulse") << Case{PulseShape::halfSine, {0.5, 1, 10, 0.3}} << "";
    QTest::newRow("not for this rock") << Case{PulseShape::rectangular, {0.5, 0.1, 10, 0.3}} << "";
}

void TestImpactSummary::theClosedFormIsQuestionedWhereOneWouldExpectIt() {
    QFETCH(Case, wanted);
    QFETCH(QString, parameter);
    const Scenario scenario = scenarioOf(wanted);
    const ImpactSummary summary = summaryOf(scenario);
    const std::vector<Alert> alerts = resultAlerts(scenario, summary);
    const Alert* alert = find(alerts, AlertCode::closedFormInvalid);
    QCOMPARE(alert == nullptr, parameter.isEmpty());
    if (!alert) return;
    QCOMPARE(QString::fromUtf8(alert->parameter.data()), parameter);
    const Groups& groups = wanted.groups;
    const double blamed =
        parameter == "tau" ? groups.tau : (parameter == "delta" ? groups.delta : groups.beta);
    QCOMPARE(alert->argument(alert->parameter).value, blamed);
    const double error = std::abs(closedFormRestitution(groups.beta) - summary.cor);
    QVERIFY(error > 1e-6);
    QCOMPARE(alert->argument("closed_form_cor").value, closedFormRestitution(groups.beta));
    QCOMPARE(alert->argument("difference").value, error);
}

static std::vector<Alert> overloads(const Scenario& scenario, const RodForces& forces) {
    return stressAlerts(scenario, sectionStresses(scenario, forces));
}

void TestImpactSummary::aRodIsWarnedOfStressAboveItsYieldStrength() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::halfSine;
    const RodForces forces{{1.6, 0.5, 3}, {1.2, 0.2, 5}, {1.1, 0.1, 30}, {1.7, 0.25, 20}};
    // F0 = 51 N s/200 µs over π·(38 mm)²/4: 224.8 MPa
    const double unit = 51 / 200e-6 / (std::acos(-1.0) * 0.038 * 0.038 / 4);
    QVERIFY(overloads(scenario, forces).empty());  // no limit is given
    scenario.rod.yieldStrength = 1.7 * unit * (1 + 1e-9);
    QVERIFY(overloads(scenario, forces).empty());
    scenario.rod.yieldStrength = 300e6;
    std::vector<Alert> alerts = overloads(scenario, forces);
    QCOMPARE(alerts.size(), std::size_t{1});
    QCOMPARE(alerts[0].level, AlertLevel::warning);
    QCOMPARE(alerts[0].code, AlertCode::stressAboveYield);
    QCOMPARE(alerts[0].parameter, std::string_view("rod.yield_strength"));
    QCOMPARE(alertText(alerts[0]),
             std::string(
                 "The rod would yield: during the blow the stress reaches 359.8 MPa in compression, at 1.83 "
                 "m from the hammer and 600 us after the start of the blow. Its yield strength is 300 MPa."));
    // Only the waves left reach it.
    scenario.rod.yieldStrength = 370e6;
    alerts = overloads(scenario, forces);
    QCOMPARE(alerts.size(), std::size_t{1});
    QCOMPARE(alerts[0].level, AlertLevel::information);
    QCOMPARE(alertText(alerts[0]),
             std::string("After the blow, residual waves would make the rod yield; the waves are not damped "
                         "here. The stress reaches 382.2 MPa in tension, at 915 mm from the hammer and 4 ms "
                         "after the start of the blow. The yield strength is 370 MPa."));
}

void TestImpactSummary::aRodIsWarnedOfTensionAboveItsFatigueStrength() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::halfSine;
    scenario.rod.fatigueStrength = 300e6;  // of compression there may be more
    QVERIFY(overloads(scenario, {{2, 0, 0}, {1, 0.5, 1}, {2, 0, 9}, {1, 0.5, 9}}).empty());
    std::vector<Alert> alerts = overloads(scenario, {{0, 0, 0}, {1, 0.5, 1}, {0, 0, 9}, {1.7, 0.25, 20}});
    QCOMPARE(alerts.size(), std::size_t{1});
    QCOMPARE(alerts[0].code, AlertCode::stressAboveFatigue);
    QCOMPARE(alerts[0].parameter, std::string_view("rod.fatigue_strength"));
    QCOMPARE(alerts[0].level, AlertLevel::information);
    alerts = overloads(scenario, {{0, 0, 0}, {1.5, 0.5, 1}, {0, 0, 9}, {1.7, 0.25, 20}});
    QCOMPARE(alerts.size(), std::size_t{1});
    QCOMPARE(alerts[0].level, AlertLevel::warning);
}

QTEST_GUILESS_MAIN(TestImpactSummary)
#include "tst_impact_summary.moc"
