// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the sections of a hammer and a string as parameters, and what follows from the sections.
#include <QTest>

#include <numbers>
#include <set>
#include <thread>

#include "core/model/alerts.h"
#include "core/model/assignments.h"
#include "core/model/parameter_text.h"
#include "core/model/scales.h"
#include "core/model/section_parameter.h"
#include "core/model/validation.h"
#include "core/report/alert_words.h"

using namespace drillwave;

namespace {

Section section(const char* name, double length, double diameter, double bore = 0) {
    Section result;
    result.name = name;
    result.length = length;
    result.diameter = diameter;
    result.bore = bore;
    return result;
}

/// Places: adapter 1; coupling 2, 4, 6; rod 3, 5, 7; bit skirt 8.
Scenario threeRods() {
    Scenario scenario;
    scenario.form = ScenarioForm::string;
    DrillString& drillString = scenario.drillString;
    drillString.hammer.sections = {section("", 0.3, 0.05), section("", 0.25, 0.038)};
    drillString.parts = {
        {1, false, {section("adapter", 0.45, 0.045, 0.012)}},
        {3, true, {section("coupling", 0.19, 0.056, 0.0145), section("rod", 3.66, 0.039, 0.0145)}},
        {1, false, {section("bit skirt", 0.07, 0.056)}}};
    return scenario;
}

QString set(Scenario& scenario, std::string_view key, std::string_view text) {
    return QString::fromStdString(assignText(scenario, key, text).text());
}

std::optional<double> valueOf(std::string_view key, const Scenario& scenario) {
    return findParameter(key)->value(scenario);
}

double zOf(double diameter, double bore) {
    return std::numbers::pi / 4 * (diameter * diameter - bore * bore) * std::sqrt(210e9 * 7850);
}

}  // namespace

class TestSectionParameter : public QObject {
    Q_OBJECT

  private slots:
    void aNameStandsForAllSectionsThatHaveIt();
    void aPlaceInARepeatStandsForItsSectionInEveryRepeat();
    void aBlankMayBeWrittenAsAnUnderscore();
    void aHammerIsSetByPlace();
    void areaAndDiameterReplaceEachOther();
    void theFirstRepeatIsSetInWholeNumbers();
    void sectionsThatDifferHaveNoCommonValue();
    void whatIsNotThereIsRefusedWithItsNeighbour_data();
    void whatIsNotThereIsRefusedWithItsNeighbour();
    void keysAreTheSameParameterFromEveryThread();
    void settingsGoFromTheGeneralToTheParticular();
    void keysOfOneSectionAreRivals_data();
    void keysOfOneSectionAreRivals();
    void placesAreThoseOfTheirOwnScenario();
    void everyNumberOfEverySectionIsListed();
    void derivedPropertiesAreThoseOfAUniformRod();
    void scalesAreThoseOfTheHammerAndTheRods();
    void groupsFollowAndThoseOfTheRockCanBeSet();
    void everyHardRangeIsHeld();
    void whatAStringMustHaveIsMissed();
    void implausibleSectionsAreRemarkedOn();
};

void TestSectionParameter::aNameStandsForAllSectionsThatHaveIt() {
    Scenario scenario = threeRods();
    scenario.drillString.parts[2].sections[0].name = "rod";
    QCOMPARE(set(scenario, "string.rod.length", "3.05 m"), QString());
    QCOMPARE(scenario.drillString.parts[1].sections[1].length, 3.05);
    QCOMPARE(scenario.drillString.parts[2].sections[0].length, 3.05);
    QCOMPARE(scenario.drillString.parts[0].sections[0].length, 0.45);
    QCOMPARE(valueOf("string.rod.length", scenario).value(), 3.05);
}

void TestSectionParameter::aPlaceInARepeatStandsForItsSectionInEveryRepeat() {
    for (const char* key : {"string.3.length", "string.5.length", "string.7.length"}) {
        Scenario scenario = threeRods();
        QCOMPARE(set(scenario, key, "3.05 m"), QString());
        Scenario byName = threeRods();
        set(byName, "string.rod.length", "3.05 m");
        QVERIFY(scenario == byName);
    }
    Scenario scenario = threeRods();
    QCOMPARE(set(scenario, "string.8.length", "80 mm"), QString());
    QCOMPARE(scenario.drillString.parts[2].sections[0].length, 0.08);
}

void TestSectionParameter::aBlankMayBeWrittenAsAnUnderscore() {
    for (const char* key : {"string.bit skirt.length", "string.bit_skirt.length"}) {
        Scenario scenario = threeRods();
        QCOMPARE(set(scenario, key, "80 mm"), QString());
        QCOMPARE(scenario.drillString.parts[2].sections[0].length, 0.08);
    }
}

void TestSectionParameter::aHammerIsSetByPlace() {
    Scenario scenario = threeRods();
    QCOMPARE(set(scenario, "hammer.1.diameter", "52 mm"), QString());
    QCOMPARE(set(scenario, "hammer.velocity", "9 m/s"), QString());
    QCOMPARE(set(scenario, "hammer.face_stiffness", "10 GN/m"), QString());
    QCOMPARE(set(scenario, "hammer.restrike", "false"), QString());
    QCOMPARE(set(scenario, "material.density", "7800 kg/m^3"), QString());
    QCOMPARE(set(scenario, "end_time", "12 ms"), QString());
    const DrillString& drillString = scenario.drillString;
    QCOMPARE(drillString.hammer.sections[0].diameter, 0.052);
    QCOMPARE(drillString.hammer.velocity, 9.0);
    QCOMPARE(drillString.hammer.faceStiffness.value(), 10e9);
    QVERIFY(!drillString.hammer.restrike);
    QCOMPARE(drillString.material.density, 7800.0);
    QCOMPARE(drillString.endTime.value(), 0.012);
    QVERIFY(set(scenario, "hammer.restrike", "0").contains("must be true or false"));
}

void TestSectionParameter::areaAndDiameterReplaceEachOther() {
    Scenario scenario = threeRods();
    QCOMPARE(set(scenario, "string.rod.area", "1000 mm^2"), QString());
    QCOMPARE(scenario.drillString.parts[1].sections[1].area.value(), 1e-3);
    QVERIFY(!valueOf("string.rod.diameter", scenario));
    QVERIFY(set(scenario, "string.rod.bore", "10 mm").contains("given by its area"));
    QCOMPARE(set(scenario, "string.rod.diameter", "40 mm"), QString());
    QVERIFY(!scenario.drillString.parts[1].sections[1].area);
    QVERIFY(areRivals("string.rod.area", "string.rod.diameter"));
    QVERIFY(areRivals("string.bit_skirt.bore", "string.bit skirt.area"));
    QVERIFY(!areRivals("string.rod.bore", "string.rod.diameter"));
    QVERIFY(!areRivals("string.rod.area", "string.coupling.diameter"));
    QVERIFY(!areRivals("string.1.area", "hammer.1.area"));
}

void TestSectionParameter::theFirstRepeatIsSetInWholeNumbers() {
    Scenario scenario = threeRods();
    QCOMPARE(set(scenario, "string.repeat", "5"), QString());
    QCOMPARE(scenario.drillString.parts[1].repeat, 5);
    QCOMPARE(expandedSections(scenario.drillString).size(), std::size_t(12));
    QCOMPARE(set(scenario, "string.12.length", "75 mm"), QString());
    QCOMPARE(scenario.drillString.parts[2].sections[0].length, 0.075);
    QVERIFY(set(scenario, "string.repeat", "2.5").contains("must be a whole number"));
    QVERIFY(set(scenario, "string.repeat", "0").contains("must be in [1, 1000]"));
    scenario.drillString.parts.erase(scenario.drillString.parts.begin() + 1);
    QVERIFY(set(scenario, "string.repeat", "2").contains("the string has no repeat"));
}

void TestSectionParameter::sectionsThatDifferHaveNoCommonValue() {
    Scenario scenario = threeRods();
    scenario.drillString.parts[2].sections[0].name = "rod";
    QVERIFY(!valueOf("string.rod.length", scenario));
    QVERIFY(findParameter("string.rod.length")->applies(scenario));
    QCOMPARE(valueOf("string.rod.loss", scenario).value(), 0.0);
}

void TestSectionParameter::whatIsNotThereIsRefusedWithItsNeighbour_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* key, const char* reason) {
        QTest::newRow(key) << QByteArray(key) << reason;
    };
    row("string.adaptor.length", "no section of the string is called `adaptor`; did you mean `adapter`?");
    row("string.hose.length", "its names: adapter, coupling, rod, bit skirt");
    row("string.9.length", "the string has only 8 sections");
    row("hammer.3.length", "the hammer has only 2 sections");
    row("hammer.rear.length", "its sections have no names, give a place: `hammer.1.length`");
    row("string.rod.lenght", "did you mean `string.rod.length`?");
    row("sting.rod.length", "did you mean `string.rod.length`?");
    row("rod.length", "only for uniform rods");
    row("pulse.duration", "only for a force instead of the hammer");
    row("pulse.shape", "only for a force instead of the hammer");
    row("tau", "follows from the lengths of hammer and string");
    row("string", "write it into the scenario file");
}

void TestSectionParameter::whatIsNotThereIsRefusedWithItsNeighbour() {
    QFETCH(QByteArray, key);
    QFETCH(QString, reason);
    Scenario scenario = threeRods();
    const QString said = set(scenario, key.constData(), "1 m");
    QVERIFY2(said.contains(reason), qPrintable(said));
    Scenario uniform;
    if (key.startsWith("string.") && findParameter(key.constData()))
        QVERIFY(set(uniform, key.constData(), "1 m").contains("only for drill strings"));
}

void TestSectionParameter::keysAreTheSameParameterFromEveryThread() {
    std::vector<KeptParameter> found(8);
    {
        std::vector<std::jthread> threads;
        for (KeptParameter& each : found)
            threads.emplace_back([&each] {
                for (int i = 1; i <= 200; ++i)
                    each = findParameter("string." + std::to_string(i) + ".density");
            });
    }
    for (const KeptParameter& each : found) QCOMPARE(each, findParameter("string.200.density"));
    QCOMPARE(QString::fromUtf8(found[0]->key.data()), QString("string.200.density"));
    QCOMPARE(QString::fromStdString(std::string(found[0]->label)), QString("density of section 200"));
    for (const char* key : {"string.rod", "string..length", "string.rod.name", "hammer.0.length",
                            "rock.rod.length", "string.00.length", "string.1234567890.length"})
        QVERIFY2(!findParameter(key), key);
}

void TestSectionParameter::settingsGoFromTheGeneralToTheParticular() {
    std::vector<std::pair<std::string_view, std::string_view>> settings{{"string.8.length", "75 mm"},
                                                                        {"string.bit_skirt.length", "80 mm"},
                                                                        {"beta", "0.7"},
                                                                        {"string.repeat", "3"},
                                                                        {"hammer.1.length", "310 mm"}};
    std::ranges::sort(settings);
    std::optional<Scenario> first;
    do {
        Assignments assignments;
        for (const auto& setting : settings) assignments.add(setting.first);
        Scenario scenario = threeRods();
        scenario.drillString.parts[1].repeat = 1;
        for (const std::size_t i : assignments.order())
            QCOMPARE(set(scenario, settings[i].first, settings[i].second), QString());
        QCOMPARE(scenario.drillString.parts[2].sections[0].length, 0.075);
        QVERIFY(std::abs(groupsOf(scenario).beta - 0.7) < 1e-15);
        if (!first) first = scenario;
        QVERIFY(scenario == *first);
    } while (std::ranges::next_permutation(settings).found);
}

// A section stands in the file once: what sets it twice would lose the first value without a word.
void TestSectionParameter::keysOfOneSectionAreRivals_data() {
    QTest::addColumn<QByteArray>("one");
    QTest::addColumn<QByteArray>("other");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* one, const char* other, const char* problem) {
        QTest::addRow("%s, %s", one, other) << QByteArray(one) << QByteArray(other) << problem;
    };
    const char* const places = "are the same section of a repeat";
    row("string.3.length", "string.5.length", places);
    row("string.3.area", "string.7.diameter", places);
    row("string.3.length", "string.4.length", "");
    row("string.3.length", "string.5.loss", "");
    row("string.3.length", "hammer.1.length", "");
    row("string.3.length", "beta", "");
    row("string.rod.length", "string.3.length", "set one section: section 3 of the string is called rod");
    row("string.7.area", "string.rod.bore", "set one section: section 7 of the string is called rod");
    row("string.bit_skirt.length", "string.8.length",
        "set one section: section 8 of the string is called bit_skirt");
    row("string.rod.length", "string.2.length", "");
    row("string.rod.length", "string.coupling.length", "");
    row("string.9.length", "string.3.length", "");
    row("string.rod.length", "string.rod.length", "set the same thing");
}

void TestSectionParameter::keysOfOneSectionAreRivals() {
    QFETCH(QByteArray, one);
    QFETCH(QByteArray, other);
    QFETCH(QString, problem);
    const Scenario scenario = threeRods();
    const auto problemOf = [&](const QByteArray& a, const QByteArray& b) {
        return QString::fromStdString(rivalProblem(a.constData(), scenario, b.constData(), scenario).text());
    };
    QCOMPARE(problemOf(one, other), problem);
    QCOMPARE(problemOf(other, one), problem);
    Assignments assignments;
    assignments.add(one.constData());
    assignments.skip();
    assignments.add(other.constData());
    if (one != other) QCOMPARE(assignments.meeting(scenario).has_value(), !problem.isEmpty());
    QVERIFY(!assignments.meeting(scenario, [](std::size_t i) { return i != 2; }));
}

// The places of an axis are counted with the repeats of its point, those of a setting as the file has them.
void TestSectionParameter::placesAreThoseOfTheirOwnScenario() {
    const Scenario three = threeRods();
    Scenario one = three;
    one.drillString.parts[1].repeat = 1;
    QVERIFY(!rivalProblem("string.4.length", one, "string.8.length", three).isEmpty());  // the bit skirt
    QCOMPARE(rivalProblem("string.4.length", three, "string.8.length", three), Message());
}

void TestSectionParameter::everyNumberOfEverySectionIsListed() {
    const Scenario scenario = threeRods();
    std::set<std::string, std::less<>> keys;
    for (const KeptParameter& parameter : sectionParameters(scenario)) {
        QVERIFY(keys.emplace(parameter->key).second);
        QVERIFY(parameter->applies(scenario) && parameter->value(scenario));
        QVERIFY(!parameter->label.empty() && !parameter->meaning.empty());
        QVERIFY(parameter->section() == "string" || parameter->section() == "hammer");
    }
    for (const char* key :
         {"hammer.2.length", "string.repeat", "string.1.bore", "string.3.loss", "string.8.length"})
        QVERIFY2(keys.contains(key), key);
    QVERIFY(!keys.contains("string.5.loss") && !keys.contains("string.1.area"));
    QVERIFY(sectionParameters(Scenario()).empty());

    Scenario other = scenario;
    set(other, "string.5.length", "3 m");
    set(other, "hammer.velocity", "9 m/s");
    const Scenario* const both[] = {&scenario, &other};
    const std::vector<KeptParameter> differing = differingParameters(both);
    QCOMPARE(differing.size(), std::size_t(2));
    QVERIFY(differing[0]->key == "hammer.velocity" && differing[1]->key == "string.3.length");
}

void TestSectionParameter::derivedPropertiesAreThoseOfAUniformRod() {
    Section rod = section("rod", 3.66, 0.039, 0.0145);
    const RodProperties properties = propertiesOf(rod, {});
    const double speed = std::sqrt(210e9 / 7850);
    QVERIFY(std::abs(properties.waveSpeed - speed) <= 1e-12 * speed);
    QVERIFY(std::abs(properties.transitTime - 3.66 / speed) <= 1e-15);
    QVERIFY(std::abs(properties.impedance / zOf(0.039, 0.0145) - 1) < 1e-14);
    QVERIFY(std::abs(properties.mass / (properties.impedance * properties.transitTime) - 1) < 1e-14);
    rod.youngsModulus = 70e9;
    rod.density = 2700;
    rod.area = 1e-3;
    QVERIFY(std::abs(propertiesOf(rod, {}).impedance / (1e-3 * std::sqrt(70e9 * 2700)) - 1) < 1e-14);
}

// files §1.3; the hammer of the T38 string has 6.85 kg, 342 J and 68.5 N s.
void TestSectionParameter::scalesAreThoseOfTheHammerAndTheRods() {
    Scenario scenario = threeRods();
    Scales scales = scalesOf(scenario);
    QVERIFY(std::abs(scales.energy - 342) < 1 && std::abs(scales.impulse - 68.5) < 0.1);
    const double speed = std::sqrt(210e9 / 7850);
    const double z = zOf(0.039, 0.0145);
    const auto near = [](double a, double b) { return std::abs(a / b - 1) < 1e-13; };
    QVERIFY(near(scales.time, 2 * 0.55 / speed));
    QVERIFY(near(scales.force, z * 10 / 2));
    QVERIFY(near(scales.stress, scales.force / (std::numbers::pi / 4 * (0.039 * 0.039 - 0.0145 * 0.0145))));
    QVERIFY(near(scales.velocity, 10) && near(scales.particleVelocity, 5));
    QVERIFY(near(scales.penetration, 10 * scales.time));
    QVERIFY(near(scales.stiffness, z / scales.time));
    QVERIFY(near(scales.length, 0.45 + 3 * (0.19 + 3.66) + 0.07));
    QCOMPARE(pulseDuration(scenario), scales.time);
    QCOMPARE(pulseImpulse(scenario), scales.impulse);
    // A lumped mass counts; without a section called rod the longest one rules.
    scenario.drillString.hammer.sections[0].massAfter = 1;
    QVERIFY(near(scalesOf(scenario).impulse, scales.impulse + 10));
    scenario.drillString.parts[1].sections[1].name = "";
    QCOMPARE(scalesOf(scenario).force, scales.force);
    scenario.drillString.parts[0].sections[0].name = "rod";
    QVERIFY(near(scalesOf(scenario).force, zOf(0.045, 0.012) * 5));
}

void TestSectionParameter::groupsFollowAndThoseOfTheRockCanBeSet() {
    Scenario scenario = threeRods();
    const Scales scales = scalesOf(scenario);
    const double speed = std::sqrt(210e9 / 7850);
    QVERIFY(std::abs(groupsOf(scenario).tau - 12.07 / speed / scales.time) < 1e-12);
    QCOMPARE(groupsOf(scenario).beta, scenario.bitRock.stiffness / scales.stiffness);
    QCOMPARE(set(scenario, "delta", "0.3"), QString());
    QVERIFY(std::abs(scenario.bitRock.gap - 0.3 * scales.penetration) < 1e-15);
    QCOMPARE(set(scenario, "gamma", "0.2"), QString());
    QCOMPARE(scenario.bitRock.gamma, 0.2);
    QVERIFY(!findParameter("tau")->applies(scenario));
    QVERIFY(!isGiven(*findParameter("beta"), scenario));
}

void TestSectionParameter::everyHardRangeIsHeld() {
    const Scenario base = threeRods();
    QVERIFY(validate(base).empty());
    int held = 0;
    std::vector<KeptParameter> all = sectionParameters(base);
    for (const Parameter& parameter : parameters())
        if (isGiven(parameter, base)) all.emplace_back(parameter);
    for (const KeptParameter& parameter : all) {
        for (const double wrong : {parameter->hard.low - 1, std::nan(""), HUGE_VAL}) {
            Scenario scenario = base;
            parameter->assign(scenario, wrong);
            const bool found = std::ranges::any_of(
                validate(scenario), [&](const InputProblem& p) { return p.key == parameter->key; });
            QVERIFY2(found, std::string(parameter->key).c_str());
            ++held;
        }
    }
    QVERIFY(held > 100);
}

void TestSectionParameter::whatAStringMustHaveIsMissed() {
    const auto keys = [](const Scenario& scenario) {
        QStringList list;
        for (const InputProblem& problem : validate(scenario)) list << QString::fromStdString(problem.key);
        return list;
    };
    Scenario empty;
    empty.form = ScenarioForm::string;
    QCOMPARE(keys(empty), QStringList("string"));
    Scenario scenario = threeRods();
    scenario.drillString.parts[1].sections[1].bore = 0.039;
    scenario.drillString.parts[2].sections[0].name = "12";
    QCOMPARE(keys(scenario), QStringList({"string.3.bore", "string.8.name"}));
    scenario = threeRods();
    scenario.drillString.parts[1].repeat = 900;
    QCOMPARE(keys(scenario), QStringList("string"));
    scenario = threeRods();
    scenario.drillString.parts[0].sections[0].diameter = 1e200;
    QCOMPARE(keys(scenario), QStringList("string.1.diameter"));
    scenario = threeRods();
    scenario.drillString.hammer.sections[0].attenuation = 0.01;
    scenario.drillString.hammer.sections[0].loss = 0.02;
    QCOMPARE(keys(scenario), QStringList({"hammer.1.attenuation", "hammer.1.loss"}));
    scenario.drillString.hammer.sections = {scenario.drillString.hammer.sections[0]};
    QCOMPARE(keys(scenario), QStringList("hammer.1.attenuation"));  // its loss has no joint
    scenario = threeRods();
    scenario.drillString.parts[0].group = true;
    scenario.drillString.parts[0].sections.clear();
    QVERIFY(keys(scenario).contains("string"));
    // The rod and the pulse of a string are not looked at.
    scenario = threeRods();
    scenario.rod.length = -1;
    scenario.pulse.shape = PulseShape::table;
    QVERIFY(validate(scenario).empty());
}

void TestSectionParameter::implausibleSectionsAreRemarkedOn() {
    Scenario scenario = threeRods();
    const auto keys = [&] {
        QStringList list;
        for (const Alert& alert : alertsFor(scenario))
            if (alert.code == AlertCode::implausibleValue) list << QString::fromStdString(alert.parameter);
        return list;
    };
    QCOMPARE(keys(), QStringList());
    scenario.drillString.parts[1].sections[0].length = 190;
    scenario.drillString.hammer.velocity = 100;
    QCOMPARE(keys(), QStringList({"hammer.velocity", "string.2.length"}));
    QCOMPARE(
        QString::fromStdString(alertText(alertsFor(scenario)[1])),
        QString(
            "The input length of 1st to 3rd coupling = 190 m is outside its typical range, 10 mm to 10 m."));
}

QTEST_GUILESS_MAIN(TestSectionParameter)
#include "tst_section_parameter.moc"
