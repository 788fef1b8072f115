// SPDX-License-Identifier: GPL-3.0-or-later
// Groups and scales: the way from SI to dimensionless numbers and back.
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/model/scales.h"

using namespace drillwave;

namespace {

/// Products and square roots of a few factors: some roundings.
constexpr double rounding = 2e-15;

void compareClosely(double value, double expected) {
    QVERIFY2(std::abs(value - expected) <= rounding * std::abs(expected),
             qPrintable(QString::number(value, 'g', 17)));
}

Scenario pistonScenario(double diameter) {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::piston;
    scenario.pulse.piston.diameter = diameter;
    return scenario;
}

}  // namespace

class TestScales : public QObject {
    Q_OBJECT

  private slots:
    void impedanceEqualsMassOverTransitTime();
    void anAreaReplacesDiameterAndBore();
    void groupsFollowTheirDefinitions();
    void scalesFollowTheirDefinitions();
    void thePapersGapOfOneMetreOfRod();
    void groupsDoNotDependOnTheScaleOfTheDrill();
    void aDimensionlessScenarioIsItsGroups();
    void thePistonsStepIsItsRoundTrip();
    void aHeavyPistonHandsOverAllItsMomentum();
    void aLightPistonBouncesOffAfterOneStep();
    void aMatchedPistonIsTheSameFromBothSides();
    void thePistonsMaterialIsTheRodsUnlessGiven();
    void aTableHasItsOwnDurationAndImpulse();
    void theMeanForceLeadsBackToTheImpulse();
};

void TestScales::impedanceEqualsMassOverTransitTime() {
    Rod hollow;
    hollow.bore = 0.0145;
    const RodProperties rod = propertiesOf(hollow);
    compareClosely(rod.impedance, rod.mass / rod.transitTime);
    compareClosely(rod.area, std::numbers::pi / 4 * (0.038 * 0.038 - 0.0145 * 0.0145));
    compareClosely(rod.waveSpeed, std::sqrt(210e9 / 7850));
}

void TestScales::anAreaReplacesDiameterAndBore() {
    Rod rod;
    rod.bore = 0.02;
    rod.area = 1e-3;
    QCOMPARE(propertiesOf(rod).area, 1e-3);
}

void TestScales::groupsFollowTheirDefinitions() {
    Scenario scenario;
    scenario.bitRock.gap = 0.4e-3;
    const RodProperties rod = propertiesOf(scenario.rod);
    const Groups groups = groupsOf(scenario);
    compareClosely(groups.beta, scenario.bitRock.stiffness * scenario.pulse.duration / rod.impedance);
    QCOMPARE(groups.gamma, scenario.bitRock.gamma);
    compareClosely(groups.tau, scenario.rod.length / rod.waveSpeed / scenario.pulse.duration);
    compareClosely(groups.delta, scenario.bitRock.gap * rod.impedance / (2 * scenario.pulse.impulse));
}

void TestScales::scalesFollowTheirDefinitions() {
    const Scenario scenario;
    const RodProperties rod = propertiesOf(scenario.rod);
    const Scales scales = scalesOf(scenario);
    QCOMPARE(scales.time, 200e-6);
    QCOMPARE(scales.impulse, 51.0);
    compareClosely(scales.force, 255e3);
    compareClosely(scales.velocity, 51 / rod.mass);
    compareClosely(scales.penetration, 2 * 51 / rod.impedance);
    compareClosely(scales.stiffness, rod.impedance / 200e-6);
    compareClosely(scales.energy, rod.mass * scales.velocity * scales.velocity / 2);
    QCOMPARE(scales.length, 3.66);
    compareClosely(scales.stress, 255e3 / rod.area);
    // I0 = m v0 in a pulse of length t0 is F0/Z = τ v0 in the rod of length τ t0
    compareClosely(scales.particleVelocity, groupsOf(scenario).tau * scales.velocity);
}

// The paper, section 5.1: d0 = 0.4 mm for L = 1 m, c = 5000 m/s, v0 = 1 m/s.
void TestScales::thePapersGapOfOneMetreOfRod() {
    Scenario scenario;
    scenario.rod.length = 1;
    scenario.rod.density = 8000;
    scenario.rod.youngsModulus = 8000 * 5000.0 * 5000.0;
    scenario.pulse.impulse = propertiesOf(scenario.rod).mass * 1;
    compareClosely(scalesOf(scenario).penetration, 0.4e-3);
}

void TestScales::groupsDoNotDependOnTheScaleOfTheDrill() {
    Scenario model;
    model.bitRock.gap = 0.3e-3;
    // A drill ten times as large in every length and time: areas 100, impedance 100, impulse 1000.
    Scenario large = model;
    large.rod.length *= 10;
    large.rod.diameter *= 10;
    large.pulse.duration *= 10;
    large.pulse.impulse *= 1000;
    large.bitRock.stiffness *= 10;
    large.bitRock.gap *= 10;
    compareClosely(groupsOf(large).beta, groupsOf(model).beta);
    compareClosely(groupsOf(large).tau, groupsOf(model).tau);
    compareClosely(groupsOf(large).delta, groupsOf(model).delta);
}

void TestScales::aDimensionlessScenarioIsItsGroups() {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = {.beta = 2, .gamma = 0.3, .tau = 4, .delta = 0.5};
    QVERIFY(groupsOf(scenario) == scenario.groups);
    QVERIFY(scalesOf(scenario) == Scales());
    scenario.pulse.piston.impedanceRatio = 3;
    QCOMPARE(pistonImpedanceRatio(scenario), 3.0);
}

void TestScales::thePistonsStepIsItsRoundTrip() {
    const Scenario scenario = pistonScenario(0.038);
    compareClosely(pulseDuration(scenario), 2 * 0.5 / std::sqrt(210e9 / 7850));
}

void TestScales::aHeavyPistonHandsOverAllItsMomentum() {
    const Scenario scenario = pistonScenario(0.076);
    compareClosely(pistonImpedanceRatio(scenario), 4);
    const double mass = 7850 * std::numbers::pi / 4 * 0.076 * 0.076 * 0.5;
    compareClosely(pulseImpulse(scenario), mass * 10);
    // The staircase added up: F_n = v Zh Zr/(Zh + Zr) R^n, each for t0.
    const double rod = propertiesOf(scenario.rod).impedance;
    double sum = 0;
    for (int n = 0; n < 200; ++n) sum += 10 * (4 * rod * rod / (5 * rod)) * std::pow(3.0 / 5, n);
    compareClosely(pulseImpulse(scenario), sum * pulseDuration(scenario));
}

void TestScales::aLightPistonBouncesOffAfterOneStep() {
    const Scenario scenario = pistonScenario(0.019);
    compareClosely(pistonImpedanceRatio(scenario), 0.25);
    const double rod = propertiesOf(scenario.rod).impedance;
    compareClosely(pulseImpulse(scenario), 10 * (0.25 * rod / 1.25) * pulseDuration(scenario));
}

void TestScales::aMatchedPistonIsTheSameFromBothSides() {
    const double above = pulseImpulse(pistonScenario(0.038 * (1 + 1e-9)));
    const double below = pulseImpulse(pistonScenario(0.038 * (1 - 1e-9)));
    QVERIFY(std::abs(above / below - 1) < 1e-8);
}

void TestScales::thePistonsMaterialIsTheRodsUnlessGiven() {
    Scenario scenario = pistonScenario(0.038);
    scenario.rod.youngsModulus = 100e9;
    compareClosely(pistonImpedanceRatio(scenario), 1);
    scenario.pulse.piston.youngsModulus = 400e9;
    compareClosely(pistonImpedanceRatio(scenario), 2);
    scenario.pulse.piston.density = 4 * 7850;
    compareClosely(pistonImpedanceRatio(scenario), 4);
}

void TestScales::aTableHasItsOwnDurationAndImpulse() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tablePoints = {{10e-6, 0}, {60e-6, 200e3}, {110e-6, 200e3}, {210e-6, 0}};
    compareClosely(pulseDuration(scenario), 200e-6);
    compareClosely(pulseImpulse(scenario), 5 + 10 + 10);
}

void TestScales::theMeanForceLeadsBackToTheImpulse() {
    for (int i = 1; i <= 2000; ++i) {
        Pulse pulse;
        const double force = 1e5 + 137.0 * i;
        pulse.duration = 1e-6 * i;
        pulse.impulse = force * pulse.duration;
        QCOMPARE(meanForce(pulse) * pulse.duration, pulse.impulse);
    }
}

QTEST_APPLESS_MAIN(TestScales)
#include "tst_scales.moc"
