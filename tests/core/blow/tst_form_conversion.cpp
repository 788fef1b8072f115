// SPDX-License-Identifier: GPL-3.0-or-later
// A uniform rod becomes a drill string of the same results, and a string a uniform rod, saying what is lost.
#include <QTest>
#include <cmath>

#include "core/blow/blow.h"
#include "core/model/form_conversion.h"
#include "core/model/validation.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario example(const char* name) {
    return parseScenario(findExample(name)->text, name).scenario;
}

// Rod and hammer of whole millimetres.
Scenario rectangular() {
    Scenario scenario = example("t38_medium_rock");
    scenario.pulse.shape = PulseShape::rectangular;
    scenario.pulse.duration = 2 * 0.52 / propertiesOf(scenario.rod).waveSpeed;
    return scenario;
}

Blow solved(const Scenario& scenario) {
    return solveBlow(scenario, {}, Detail::summary);
}

bool mentions(const Conversion& conversion, const char* words) {
    return std::ranges::any_of(conversion.lost, [&](const Message& sentence) {
        return sentence.text().find(words) != std::string::npos;
    });
}

}  // namespace

class TestFormConversion : public QObject {
    Q_OBJECT

  private slots:
    void aRodWithARectangularBlowHasTheSameResultsAsAString() {
        const Scenario rod = rectangular();
        const Conversion conversion = stringOf(rod);
        QVERIFY(conversion.lost.empty());
        QVERIFY(validate(conversion.scenario).empty());
        const Blow before = solved(rod), after = solved(conversion.scenario);
        QVERIFY(before.isSolved() && after.isSolved());
        QVERIFY2(std::abs(before.summary.cor - after.summary.cor) < 1e-11,
                 QByteArray::number(after.summary.cor - before.summary.cor));
        const double forceBefore = before.summary.peakForce * before.scales.force;
        const double forceAfter = after.summary.peakForce * after.scales.force;
        QVERIFY(std::abs(forceAfter / forceBefore - 1) < 1e-11);
    }

    void aPistonIsTheHammer() {
        Scenario rod = rectangular();
        rod.pulse.shape = PulseShape::piston;
        rod.pulse.piston.length = 0.6;
        rod.pulse.piston.velocity = 9;
        for (const double diameter : {0.03, 0.045}) {
            rod.pulse.piston.diameter = diameter;
            const Conversion conversion = stringOf(rod);
            const bool isStaircase = pistonImpedanceRatio(rod) > 1;
            QCOMPARE(mentions(conversion, "no longer prescribed"), isStaircase);
            const Blow before = solved(rod), after = solved(conversion.scenario);
            const double difference = std::abs(before.summary.cor - after.summary.cor);
            QVERIFY2(difference < (isStaircase ? 0.01 : 1e-10), QByteArray::number(difference));
        }
    }

    void anyOtherBlowStaysTheForceThatItIs() {
        Scenario rod = rectangular();
        for (const PulseShape shape :
             {PulseShape::halfSine, PulseShape::exponential, PulseShape::trapezoid, PulseShape::triangular}) {
            rod.pulse.shape = shape;
            const Conversion conversion = stringOf(rod);
            QVERIFY(conversion.lost.empty());
            QVERIFY(validate(conversion.scenario).empty());
            QCOMPARE(groupsOf(conversion.scenario), groupsOf(rod));
            const Blow before = solved(rod), after = solved(conversion.scenario);
            QVERIFY(std::abs(before.summary.cor - after.summary.cor) < 1e-11);
            QVERIFY(std::abs(before.summary.workRatio / after.summary.workRatio - 1) < 1e-11);
            const Conversion back = uniformRodOf(conversion.scenario);
            QVERIFY(back.lost.empty());
            QCOMPARE(back.scenario.pulse, rod.pulse);
        }
    }

    void aForceTakesThePlaceOfTheHammer() {
        const Scenario string = test::losslessString();
        const Conversion conversion = forcedStringOf(string);
        QVERIFY(validate(conversion.scenario).empty());
        QVERIFY(isForced(conversion.scenario) && isString(conversion.scenario));
        QVERIFY(mentions(conversion, "reflected"));
        QVERIFY(std::abs(pulseDuration(conversion.scenario) / pulseDuration(string) - 1) < 1e-12);
        const double momentum = pulseImpulse(string), impulse = pulseImpulse(conversion.scenario);
        const double ratio = pistonImpedanceRatio(conversion.scenario);
        QVERIFY(std::abs(impulse / momentum - std::max(1.0, 2 / (1 + ratio))) < 1e-12);
        const Blow blow = solved(conversion.scenario);
        QVERIFY(blow.isSolved() && blow.summary.energy.rockWork > 0.3);
    }

    void aHammerOfOddLengthIsRounded() {
        Scenario rod = rectangular();
        rod.pulse.duration = 200e-6;
        rod.rod.length = 12 * 0.3048;
        const Conversion conversion = stringOf(rod);
        QVERIFY(mentions(conversion, "The hammer is rounded to 520 mm"));
        QVERIFY(mentions(conversion, "The rod is rounded to 3660 mm"));
        const DrillString& drill = conversion.scenario.drillString;
        QCOMPARE(drill.hammer.sections[0].length, 0.52);
        QCOMPARE(drill.parts[0].sections[0].length, 3.66);
        QVERIFY(solveBlow(conversion.scenario, {}, Detail::histories).impact.waves);
        QVERIFY(std::abs(pulseImpulse(conversion.scenario) / pulseImpulse(rod) - 1) < 1e-12);
    }

    void whatHasNoHammerIsNoString() {
        QVERIFY(!whyNoString(example("paper_fig4b")).isEmpty());
        QVERIFY(!whyNoString(example("t38_string")).isEmpty());
        Scenario rod = rectangular();
        QVERIFY(whyNoString(rod).isEmpty());
        rod.pulse.shape = PulseShape::rigidBody;
        QVERIFY(!whyNoString(rod).isEmpty());
    }

    void aStringKeepsItsRodItsTimeAndItsHammersMomentum() {
        const Scenario string = test::losslessString();
        const Conversion conversion = uniformRodOf(string);
        const Scenario& rod = conversion.scenario;
        QVERIFY(validate(rod).empty());
        QVERIFY(!isString(rod));
        QCOMPARE(rod.rod.diameter, 0.039);
        QCOMPARE(rod.rod.bore, 0.0145);
        const double time = stringProperties(string.drillString).transitTime;
        QVERIFY(std::abs(propertiesOf(rod.rod).transitTime / time - 1) < 1e-12);
        QVERIFY(std::abs(pulseDuration(rod) / pulseDuration(string) - 1) < 1e-12);
        QVERIFY(mentions(conversion, "6 of 9 sections"));
        QVERIFY(mentions(conversion, "steps of the hammer"));
        QVERIFY(mentions(conversion, "does not strike again"));
        QVERIFY(!mentions(conversion, "losses"));
        QVERIFY(solved(rod).isSolved());
    }

    void thereAndBackLosesNothingOfARodWithAPiston() {
        Scenario rod = rectangular();
        rod.pulse.shape = PulseShape::piston;
        rod.pulse.piston.length = 0.6;
        rod.pulse.piston.diameter = 0.03;
        rod.pulse.piston.velocity = 9;
        const Conversion back = uniformRodOf(stringOf(rod).scenario);
        QVERIFY(back.lost.empty());
        QVERIFY(std::abs(solved(back.scenario).summary.cor - solved(rod).summary.cor) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(TestFormConversion)
#include "tests/support/lossless_string.h"
#include "tst_form_conversion.moc"
