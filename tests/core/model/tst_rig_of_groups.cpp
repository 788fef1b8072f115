// SPDX-License-Identifier: GPL-3.0-or-later
// A rig has the groups that it was made of.
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/blow/blow.h"
#include "core/model/form_conversion.h"
#include "core/model/scales.h"
#include "core/model/validation.h"

using namespace drillwave;

namespace {

Scenario groupsWith(PulseShape shape) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = {.beta = 0.53, .gamma = 0.15, .tau = 3.4, .delta = 0.21};
    scenario.pulse.shape = shape;
    scenario.pulse.piston.impedanceRatio = 1.7;
    if (shape == PulseShape::table) scenario.pulse.tablePoints = {{2, 0}, {3, 5}, {7, 4}, {9, 0}};
    return scenario;
}

bool isClose(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::abs(b);
}

constexpr PulseShape shapes[] = {PulseShape::rectangular, PulseShape::triangular,  PulseShape::halfSine,
                                 PulseShape::trapezoid,   PulseShape::exponential, PulseShape::piston,
                                 PulseShape::table};

}  // namespace

class TestRigOfGroups : public QObject {
    Q_OBJECT

  private slots:
    void theGroupsOfTheRigAreThoseBefore() {
        RigChoice choice;
        choice.rod.diameter = 0.039;
        choice.rod.bore = 0.0145;
        choice.rod.youngsModulus = 205e9;
        choice.meanForce = 231e3;
        choice.duration = 187e-6;
        for (const PulseShape shape : shapes)
            for (const double ratio : {0.6, 1.0, 1.7}) {
                Scenario before = groupsWith(shape);
                before.pulse.piston.impedanceRatio = ratio;
                const Scenario rig = rigOf(before, choice);
                QVERIFY2(validate(rig).empty(), invalidity(rig).text().c_str());
                const Groups groups = groupsOf(rig);
                QVERIFY(isClose(groups.beta, before.groups.beta) && isClose(groups.tau, before.groups.tau));
                QVERIFY(isClose(groups.delta, before.groups.delta));
                QCOMPARE(groups.gamma, before.groups.gamma);
                QVERIFY(isClose(pulseDuration(rig), choice.duration));
                QVERIFY(isClose(pulseImpulse(rig), choice.meanForce * choice.duration));
                if (shape == PulseShape::piston) QVERIFY(isClose(pistonImpedanceRatio(rig), ratio));
            }
    }

    void theBlowIsTheSame() {
        for (const PulseShape shape : shapes) {
            Scenario before = groupsWith(shape);
            before.bitRock.law = RockLaw::corners;
            before.bitRock.corners = {{.force = 0.3, .slope = 0.6}};
            const Blow one = solveBlow(before, {}, Detail::summary);
            const Blow other = solveBlow(rigOf(before, {}), {}, Detail::summary);
            QVERIFY(one.isSolved() && other.isSolved());
            QVERIFY(std::abs(one.summary.cor - other.summary.cor) < 1e-10);
            QVERIFY(std::abs(one.summary.peakForce - other.summary.peakForce) < 1e-10);
        }
        Scenario power = groupsWith(PulseShape::rectangular);
        power.bitRock.law = RockLaw::power;
        power.bitRock.exponent = 1.5;
        power.bitRock.referencePenetration = 0.4;
        QVERIFY(std::abs(solveBlow(power, {}, Detail::summary).summary.cor -
                         solveBlow(rigOf(power, {}), {}, Detail::summary).summary.cor) < 1e-10);
    }
};

QTEST_GUILESS_MAIN(TestRigOfGroups)
#include "tst_rig_of_groups.moc"
