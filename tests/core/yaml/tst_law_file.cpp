// SPDX-License-Identifier: GPL-3.0-or-later
// The loading curve of the rock in files and on the command line (files §1.4).
#include <QTest>

#include "core/model/law_parameter.h"
#include "core/model/parameter_text.h"
#include "core/study/rows/sweep_axis.h"
#include "core/wave/problem.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario_texts.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const std::string rod =
    "drillwave: 1\n"
    "rod: {length: 3.66 m, diameter: 38 mm, youngs_modulus: 210 GPa, density: 7850 kg/m^3}\n"
    "pulse: {shape: rectangular, duration: 200 us, impulse: 51 N s}\n";
const std::string rock = "bit_rock:\n  stiffness: 250 MN/m\n  gamma: 0.25\n";
const std::string corners =
    "  law: corners  # of a test\n"
    "  corners:\n"
    "    - {force: 90 kN, slope: 0.35}  # chips\n"
    "    - {force: 200 kN, slope: 2}\n";
const std::string groups =
    "drillwave: 1\n"
    "dimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}\n"
    "pulse: {shape: rectangular}\n";

std::string writtenAnew(const Scenario& scenario) {
    ScenarioDocument document;
    document.scenario = scenario;
    return writeScenario(document);
}

std::string problemsOf(const std::string& text) {
    std::string all;
    try {
        parseScenario(text, "file");
    } catch (const ScenarioError& error) {
        for (const InputProblem& problem : error.problems()) all += problem.text.text() + "\n";
    }
    return all;
}

}  // namespace

class TestLawFile : public QObject {
    Q_OBJECT

  private slots:
    void cornersAreReadAndWrittenBack() {
        const std::string text = rod + rock + corners;
        ScenarioDocument document = parseScenario(text, "file");
        const std::vector<RockCorner> expected{{90e3, 0.35}, {200e3, 2}};
        QVERIFY(document.scenario.bitRock.law == RockLaw::corners);
        QVERIFY(document.scenario.bitRock.corners == expected);
        QCOMPARE(writeScenario(document), text);
        document.scenario.bitRock.corners[1].force = 210e3;
        const std::string changed = writeScenario(document);
        QVERIFY(changed.find("{force: 210 kN, slope: 2}") != std::string::npos);
        QVERIFY(changed.find("# chips") != std::string::npos);
        document.scenario.bitRock.corners.push_back({300e3, 0.5});
        QVERIFY(parseScenario(writeScenario(document), "file").scenario == document.scenario);
        QCOMPARE(assignText(document.scenario, "bit_rock.law", "bilinear"), Message());
        QVERIFY(parseScenario(writeScenario(document), "file").scenario == document.scenario);
        QVERIFY(writeScenario(document).find("corner") == std::string::npos);
    }

    void aPowerLawIsReadAndWrittenBack() {
        const std::string text =
            rod + rock + "  law: power\n  exponent: 1.5\n  reference_penetration: 0.5 mm\n";
        const ScenarioDocument document = parseScenario(text, "file");
        QCOMPARE(document.scenario.bitRock.exponent, 1.5);
        QCOMPARE(document.scenario.bitRock.referencePenetration, 0.5e-3);
        QCOMPARE(writeScenario(document), text);
        QVERIFY(!problemOf(document.scenario).law.isBilinear());
    }

    void dimensionlessCornersHaveNoUnits() {
        const std::string text = groups + "bit_rock: {law: corners, corners: [{force: 0.6, slope: 0.35}]}\n";
        const ScenarioDocument document = parseScenario(text, "file");
        QCOMPARE(document.scenario.bitRock.corners.front().force, 0.6);
        QCOMPARE(writeScenario(document), text);
        QVERIFY(parseScenario(writtenAnew(document.scenario), "file").scenario == document.scenario);
        const std::string power =
            groups + "bit_rock: {law: power, exponent: 0.7, reference_penetration: 0.2}\n";
        const ScenarioDocument ofPower = parseScenario(power, "file");
        QCOMPARE(ofPower.scenario.bitRock.referencePenetration, 0.2);
        QVERIFY(parseScenario(writtenAnew(ofPower.scenario), "file").scenario == ofPower.scenario);
    }

    void forcesAreMeasuredInThoseOfTheBlow() {
        const Scenario scenario = parseScenario(rod + rock + corners, "file").scenario;
        const BitRockLaw law = problemOf(scenario).law;
        QCOMPARE(law.corners.size(), std::size_t{2});
        QCOMPARE(law.corners[0].force, 90e3 / 255e3);  // F0 = 51 N s over 200 us
        QCOMPARE(law.corners[1].slope, 2.0);
    }

    void aLawIsSetByKeys() {
        Scenario scenario = parseScenario(rod + rock, "file").scenario;
        QVERIFY(!assignText(scenario, "bit_rock.corner.1.force", "90 kN").isEmpty());
        QCOMPARE(assignText(scenario, "bit_rock.law", "corners"), Message());
        QVERIFY(!validate(scenario).empty());
        QCOMPARE(assignText(scenario, "bit_rock.corner.1.force", "90 kN"), Message());
        QCOMPARE(assignText(scenario, "bit_rock.corner.1.slope", "0.35"), Message());
        QVERIFY(validate(scenario).empty());
        QCOMPARE(assignText(scenario, "bit_rock.corner.3.force", "300 kN"), Message());
        QVERIFY(!validate(scenario).empty());  // there is no second one
        Scenario bare = parseScenario(groups, "file").scenario;
        QCOMPARE(assignText(bare, "bit_rock.law", "corners"), Message());
        QVERIFY(!assignText(bare, "bit_rock.corner.1.force", "90 kN").isEmpty());
        QCOMPARE(assignText(bare, "bit_rock.corner.1.force", "0.6"), Message());
        QCOMPARE(bare.bitRock.corners.front().force, 0.6);
        QVERIFY(!assignText(bare, "bit_rock.corner.65.force", "0.6").isEmpty());
    }

    void axesTakeLawsAndCorners() {
        const ParsedAxis laws = parseAxis("bit_rock.law=bilinear,corners");
        QVERIFY2(laws.problem.isEmpty(), laws.problem.text().c_str());
        QCOMPARE(std::string(laws.axis.key()), std::string("bit_rock.law"));
        Scenario scenario = parseScenario(rod + rock + corners, "file").scenario;
        QCOMPARE(laws.axis.assign(scenario, laws.axis.value(0)), Message());
        QVERIFY(scenario.bitRock.law == RockLaw::bilinear && scenario.bitRock.corners.empty());
        QVERIFY(!parseAxis("bit_rock.law=bilinear,curved").problem.isEmpty());
        const ParsedAxis inSi = parseAxis("bit_rock.corner.1.force=50kN:100kN:3");
        QVERIFY(inSi.problem.isEmpty());
        QVERIFY(inSi.axis.parameter->quantity == Quantity::force);
        const ParsedAxis inScales = parseAxis("bit_rock.corner.1.force=0.2:0.6:3");
        QVERIFY(inScales.problem.isEmpty());
        QVERIFY(inScales.axis.parameter->quantity == Quantity::ratio);
        QVERIFY(!inScales.axis.assign(scenario, 0.2).isEmpty());
    }

    void whatIsWrongIsToldWhereItStands_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("problem");
        const auto row = [](const char* what, const std::string& text, const char* problem) {
            QTest::newRow(what) << QString::fromStdString(text) << QString(problem);
        };
        row("steeper than the way down",
            rod + rock + "  law: corners\n  corners: [{force: 9 kN, slope: 4.1}]\n",
            "bit_rock.corners.1.slope = 4.1 (must be at most 1/gamma = 4");
        row("not increasing",
            rod + rock + "  law: corners\n  corners: [{force: 9 kN, slope: 2}, {force: 8 kN, slope: 1}]\n",
            "bit_rock.corners.2.force = 8 kN (must be greater than");
        row("another law's key", rod + rock + "  exponent: 1.5\n", "bit_rock.exponent (only for a power law");
        row("corners of no law", rod + rock + "  corners: [{force: 9 kN, slope: 2}]\n",
            "bit_rock.corners (only for a law with corners");
        row("no corners", rod + rock + "  law: corners\n", "bit_rock.corners (is missing");
        row("no such law", rod + rock + "  law: curved\n", "must be one of bilinear, corners, power");
        row("no slope", rod + rock + "  law: corners\n  corners: [{force: 9 kN}]\n",
            "bit_rock.corners.1.slope (is missing");
        row("a unit where there is none",
            groups + "bit_rock: {law: corners, corners: [{force: 9 kN, slope: 2}]}\n",
            "bit_rock.corners.1.force = 9 kN");
        row("no unit", rod + rock + "  law: corners\n  corners: [{force: 9, slope: 2}]\n",
            "bit_rock.corners.1.force = 9 (");
        row("stiffness beside groups", groups + "bit_rock: {law: power, stiffness: 3 MN/m}\n",
            "bit_rock.stiffness (cannot be combined with");
        std::string many = rod + rock + "  law: corners\n  corners:\n";
        for (int i = 1; i <= 65; ++i) many += "    - {force: " + std::to_string(i) + " kN, slope: 1}\n";
        row("65 corners", many, "has 65 corners, at most 64 are possible");
    }
    void whatIsWrongIsToldWhereItStands() {
        QFETCH(QString, text);
        QFETCH(QString, problem);
        const QString told = QString::fromStdString(problemsOf(text.toStdString()));
        QVERIFY2(told.contains(problem), told.toUtf8());
    }
};

QTEST_GUILESS_MAIN(TestLawFile)
#include "tst_law_file.moc"
