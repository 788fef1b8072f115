// SPDX-License-Identifier: GPL-3.0-or-later
// Validation: every problem at once, and remarks on what is valid but strained.
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/model/alerts.h"
#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/pulse_force.h"
#include "core/model/validation.h"
#include "tests/support/scenario.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

Scenario withTable(std::vector<TablePoint> points) {
    Scenario scenario = dimensionless(PulseShape::table);
    scenario.pulse.tablePoints = std::move(points);
    return scenario;
}

bool hasAlert(const Scenario& scenario, AlertCode code) {
    return std::ranges::any_of(alertsFor(scenario), [&](const Alert& alert) { return alert.code == code; });
}

QString onlyProblem(const Scenario& scenario) {
    const std::vector<InputProblem> problems = validate(scenario);
    return problems.size() == 1 ? QString::fromStdString(problems.front().text.text())
                                : QString("%1 problems").arg(problems.size());
}

}  // namespace

class TestValidation : public QObject {
    Q_OBJECT

  private slots:
    void theDefaultScenarioIsValidInBothForms();
    void everyProblemIsFoundAtOnce();
    void everyHardRangeIsHeld();
    void valuesOfTheOtherFormAreNotChecked();
    void theBoreMustFitIntoTheRod();
    void riseAndFallMustFitIntoTheDuration();
    void tablesMustBeForcesInTime_data();
    void tablesMustBeForcesInTime();
    void aTableMayBeTooLong();
    void aPistonMayBeTooStiff();
    void groupsThatOverflowAreFound();
    void implausibleValuesAreRemarkedOn();
    void numbersOfTheLoadingCurveAreRemarkedOn();
    void moreCornersThanThereMayBeAreOneProblem();
    void aBlowLongerThanTheRoundTripIsRemarkedOn_data();
    void aBlowLongerThanTheRoundTripIsRemarkedOn();
    void aGapHasNoEffectOnTheReferenceCase();
    void anUnmatchedPistonIsRemarkedOn();
    void aHammerThatNobodyGaveIsRemarkedOn();
};

void TestValidation::theDefaultScenarioIsValidInBothForms() {
    QVERIFY(validate(Scenario()).empty());
    for (const PulseShape shape : {PulseShape::rectangular, PulseShape::piston, PulseShape::rigidBody})
        QVERIFY(validate(dimensionless(shape)).empty());
    QVERIFY(alertsFor(Scenario()).empty());
}

void TestValidation::everyProblemIsFoundAtOnce() {
    Scenario scenario;
    scenario.rod.length = -1;
    scenario.rod.bore = 0.05;
    scenario.pulse.shape = PulseShape::trapezoid;
    scenario.pulse.rise = 0.7;
    scenario.pulse.fall = 0.7;
    scenario.bitRock.gamma = 1.3;
    scenario.drill.thrust = std::nan("");
    const std::vector<InputProblem> problems = validate(scenario);
    QStringList keys;
    for (const InputProblem& problem : problems) keys << QString::fromStdString(problem.key);
    QCOMPARE(keys, QStringList({"rod.length", "bit_rock.gamma", "drill.thrust", "rod.bore", "pulse.fall"}));
    QCOMPARE(QString::fromStdString(problems[0].text.text()),
             QString("rod.length = -1 m (must be greater than 0)"));
    QCOMPARE(QString::fromStdString(problems[1].text.text()),
             QString("bit_rock.gamma = 1.3 (must be in (0, 1])"));
}

void TestValidation::everyHardRangeIsHeld() {
    for (const PulseShape shape : {PulseShape::rectangular, PulseShape::trapezoid, PulseShape::piston}) {
        for (Scenario base : {Scenario(), dimensionless(shape)}) {
            base.pulse.shape = shape;
            for (const Parameter& parameter : parameters()) {
                if (!isGiven(parameter, base)) continue;
                for (const double wrong : {parameter.hard.low - 1, std::nan(""), HUGE_VAL}) {
                    Scenario scenario = base;
                    parameter.assign(scenario, wrong);
                    const std::vector<InputProblem> problems = validate(scenario);
                    const bool found = std::ranges::any_of(
                        problems, [&](const InputProblem& p) { return p.key == parameter.key; });
                    QVERIFY2(found, std::string(parameter.key).c_str());
                }
            }
        }
    }
}

void TestValidation::valuesOfTheOtherFormAreNotChecked() {
    Scenario scenario = dimensionless(PulseShape::rectangular);
    scenario.rod.length = -1;
    scenario.bitRock.gamma = 7;
    QVERIFY(validate(scenario).empty());
}

void TestValidation::theBoreMustFitIntoTheRod() {
    Scenario scenario;
    scenario.rod.bore = scenario.rod.diameter;
    QCOMPARE(onlyProblem(scenario), QString("rod.bore = 38 mm (must be less than the diameter of 38 mm)"));
    scenario.rod.area = 1e-3;
    QVERIFY(validate(scenario).empty());
}

void TestValidation::riseAndFallMustFitIntoTheDuration() {
    Scenario scenario = dimensionless(PulseShape::trapezoid);
    scenario.pulse.rise = 0.75;
    scenario.pulse.fall = 0.5;
    QVERIFY(onlyProblem(scenario).contains("they are 1.25"));
    scenario.pulse.rise = 0.7;
    scenario.pulse.fall = 0.3;
    QVERIFY(validate(scenario).empty());
}

void TestValidation::tablesMustBeForcesInTime_data() {
    QTest::addColumn<QList<double>>("values");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no point") << QList<double>{} << "at least two points";
    QTest::newRow("one point") << QList<double>{0, 1} << "at least two points";
    QTest::newRow("backwards") << QList<double>{0, 1, 1, 1, 0.5, 0} << "point 3 must be later";
    QTest::newRow("standing still") << QList<double>{0, 1, 0, 2} << "point 2 must be later";
    QTest::newRow("pulling") << QList<double>{0, 1, 1, -1} << "point 2 has a negative force";
    QTest::newRow("no force") << QList<double>{0, 0, 1, 0} << "force greater than 0";
    QTest::newRow("infinite force") << QList<double>{0, 0, 1, HUGE_VAL} << "finite";
    QTest::newRow("time overflows") << QList<double>{-1.7e308, 1, 1.7e308, 1} << "too long";
}

void TestValidation::tablesMustBeForcesInTime() {
    QFETCH(QList<double>, values);
    QFETCH(QString, reason);
    std::vector<TablePoint> points;
    for (int i = 0; i + 1 < values.size(); i += 2) points.push_back({values[i], values[i + 1]});
    const QString problem = onlyProblem(withTable(points));
    QVERIFY2(problem.startsWith("pulse.points") && problem.contains(reason), qPrintable(problem));
}

void TestValidation::aTableMayBeTooLong() {
    std::vector<TablePoint> points;
    for (int i = 0; i <= maximumPulseSegments; ++i) points.push_back({static_cast<double>(i), 1});
    QVERIFY(onlyProblem(withTable(points)).contains("100000"));
    points.pop_back();
    QVERIFY(validate(withTable(points)).empty());
}

void TestValidation::aPistonMayBeTooStiff() {
    Scenario scenario = dimensionless(PulseShape::piston);
    scenario.pulse.piston.impedanceRatio = 1e5;
    QVERIFY(onlyProblem(scenario).contains("exponential"));
    scenario.pulse.piston.impedanceRatio = 1e300;
    QVERIFY(onlyProblem(scenario).contains("exponential"));
    Scenario inSi;
    inSi.pulse.shape = PulseShape::piston;
    inSi.pulse.piston.diameter = 10;
    QVERIFY(onlyProblem(inSi).startsWith("pulse.diameter"));
}

void TestValidation::groupsThatOverflowAreFound() {
    Scenario scenario;
    scenario.bitRock.stiffness = 1e308;
    scenario.pulse.duration = 1e10;
    QVERIFY(onlyProblem(scenario).startsWith("beta"));
    scenario = Scenario();
    scenario.pulse.impulse = 1e300;
    scenario.rod.length = 1e-300;
    QVERIFY(!validate(scenario).empty());
}

void TestValidation::implausibleValuesAreRemarkedOn() {
    Scenario scenario;
    scenario.rod.youngsModulus = 210;  // meant in GPa
    const std::vector<Alert> alerts = alertsFor(scenario);
    QVERIFY(!alerts.empty());
    QCOMPARE(alerts.front().code, AlertCode::implausibleValue);
    QCOMPARE(alerts.front().parameter, std::string_view("rod.youngs_modulus"));
    QCOMPARE(alerts.front().argument("value").value, 210.0);
    QVERIFY(alerts.front().level == AlertLevel::warning);
}

void TestValidation::numbersOfTheLoadingCurveAreRemarkedOn() {
    const auto remarked = [](const Scenario& scenario) {
        std::vector<std::string> keys;
        for (const Alert& alert : alertsFor(scenario))
            if (alert.code == AlertCode::implausibleValue) keys.push_back(alert.parameter);
        return keys;
    };
    using Keys = std::vector<std::string>;
    Scenario scenario;
    scenario.bitRock.law = RockLaw::corners;
    scenario.bitRock.corners = {{90e3, 0.35}, {600e3, 0.04}};  // usual: 5 to 500 kN, 0.05 to 5
    QCOMPARE(remarked(scenario), (Keys{"bit_rock.corner.2.force", "bit_rock.corner.2.slope"}));
    scenario.bitRock = withLaw(scenario.bitRock, RockLaw::power);
    scenario.bitRock.exponent = 2.5;                // 0.5 to 2
    scenario.bitRock.referencePenetration = 10e-3;  // 0.05 to 5 mm
    QCOMPARE(remarked(scenario), (Keys{"bit_rock.exponent", "bit_rock.reference_penetration"}));
    // In groups: forces in F0, penetrations in d0.
    scenario.form = ScenarioForm::dimensionless;
    scenario.bitRock.referencePenetration = 0.01;
    QCOMPARE(remarked(scenario), (Keys{"bit_rock.exponent", "bit_rock.reference_penetration"}));
    scenario.bitRock = withLaw(scenario.bitRock, RockLaw::corners);
    scenario.bitRock.corners = {{0.5, 1}, {3, 1}};
    QCOMPARE(remarked(scenario), Keys{"bit_rock.corner.2.force"});
}

void TestValidation::moreCornersThanThereMayBeAreOneProblem() {
    Scenario scenario;
    scenario.bitRock.law = RockLaw::corners;
    for (int i = 1; i <= 65; ++i) scenario.bitRock.corners.push_back({i * 1e3, 0.5});
    const std::vector<InputProblem> problems = validate(scenario);
    QCOMPARE(problems.size(), std::size_t(1));
    QVERIFY2(problems.front().text.text().find("at most 64") != std::string::npos,
             problems.front().text.text().c_str());
    scenario.bitRock.corners.pop_back();
    QVERIFY(validate(scenario).empty());
}

void TestValidation::aBlowLongerThanTheRoundTripIsRemarkedOn_data() {
    QTest::addColumn<PulseShape>("shape");
    QTest::addColumn<double>("tau");
    QTest::addColumn<bool>("remark");
    QTest::newRow("just fits") << PulseShape::rectangular << 0.5 << false;
    QTest::newRow("a little too long") << PulseShape::rectangular << 0.45 << true;
    QTest::newRow("decayed") << PulseShape::exponential << 5.0 << false;
    QTest::newRow("not decayed") << PulseShape::exponential << 1.0 << true;
    QTest::newRow("no force at all") << PulseShape::rigidBody << 0.1 << false;
}

void TestValidation::aBlowLongerThanTheRoundTripIsRemarkedOn() {
    QFETCH(PulseShape, shape);
    QFETCH(double, tau);
    QFETCH(bool, remark);
    Scenario scenario = dimensionless(shape);
    scenario.groups.tau = tau;
    QCOMPARE(hasAlert(scenario, AlertCode::longPulse), remark);
}

void TestValidation::aGapHasNoEffectOnTheReferenceCase() {
    Scenario scenario = dimensionless(PulseShape::rigidBody);
    QVERIFY(!hasAlert(scenario, AlertCode::gapWithoutEffect));
    scenario.groups.delta = 0.5;
    QVERIFY(hasAlert(scenario, AlertCode::gapWithoutEffect));
}

void TestValidation::anUnmatchedPistonIsRemarkedOn() {
    Scenario scenario = dimensionless(PulseShape::piston);
    QVERIFY(!hasAlert(scenario, AlertCode::pistonImpedance));
    scenario.pulse.piston.impedanceRatio = 0.5;
    QVERIFY(hasAlert(scenario, AlertCode::pistonImpedance));
    scenario.pulse.piston.impedanceRatio = 2;
    QVERIFY(hasAlert(scenario, AlertCode::pistonImpedance));
}

void TestValidation::aHammerThatNobodyGaveIsRemarkedOn() {
    QVERIFY(hasAlert(dimensionless(PulseShape::piston), AlertCode::defaultHammer));
    Scenario scenario;
    QVERIFY(!hasAlert(scenario, AlertCode::defaultHammer));
    QCOMPARE(assignText(scenario, "pulse.shape", "piston"), Message());
    QVERIFY(hasAlert(scenario, AlertCode::defaultHammer));
    scenario.pulse.piston.velocity = 9;
    QVERIFY(!hasAlert(scenario, AlertCode::defaultHammer));
}

QTEST_APPLESS_MAIN(TestValidation)
#include "tst_validation.moc"
