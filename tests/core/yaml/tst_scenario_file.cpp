// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario files as they are read: the two forms of files §1, tables beside them, any locale.
#include <QTest>

#include <QTemporaryDir>
#include <locale>

#include "core/model/parameter_text.h"
#include "core/model/scales.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario_texts.h"

using namespace drillwave;
using namespace drillwave::test;

class TestScenarioFile : public QObject {
    Q_OBJECT

  private slots:
    void theFileOfTheContractIsRead();
    void theDimensionlessFileOfTheContractIsRead();
    void everyExampleLoadsAndSavesByteForByte();
    void everyShapeIsRead_data();
    void everyShapeIsRead();
    void optionalValuesHaveTheirDefaults();
    void anAreaReplacesTheDiameter();
    void aMeanForceIsReadAndKept();
    void aTableFileIsReadBesideTheScenario();
    void tableFilesAreReadAsRecordsAre_data();
    void tableFilesAreReadAsRecordsAre();
    void aTableFileIsWrittenBackByItsName();
    void problemsOfATableFileHaveItsLines_data();
    void problemsOfATableFileHaveItsLines();
    void theUsersLocaleChangesNothing();
};

void TestScenarioFile::theFileOfTheContractIsRead() {
    const Scenario scenario = parsed(t38).scenario;
    Scenario expected;
    expected.title = "T38 rod, medium rock";
    expected.rod.bore = 0.0145;
    expected.drill.blowFrequency = 60;
    expected.drill.thrust = 8000;
    QVERIFY(scenario == expected);
}

void TestScenarioFile::theDimensionlessFileOfTheContractIsRead() {
    Scenario expected;
    expected.title = "Fig. 4 (b) of the paper";
    expected.form = ScenarioForm::dimensionless;
    expected.groups = {.beta = 0.5, .gamma = 0.1, .tau = 10, .delta = 0};
    QVERIFY(parsed(figure4b).scenario == expected);
}

void TestScenarioFile::everyExampleLoadsAndSavesByteForByte() {
    QVERIFY(!builtInExamples().empty());
    for (const Example& example : builtInExamples()) {
        const ScenarioDocument document = parseScenario(example.text, example.name);
        compareText(writeScenario(document), std::string(example.text));
        QVERIFY(!document.scenario.title.empty());
        QVERIFY(validate(document.scenario).empty());
    }
}

void TestScenarioFile::everyShapeIsRead_data() {
    QTest::addColumn<QString>("pulse");
    QTest::addColumn<PulseShape>("shape");
    for (const char* shape : {"rectangular", "triangular", "half_sine", "exponential", "rigid_body"})
        QTest::newRow(shape) << QString("pulse: {shape: %1, duration: 0.2 ms, impulse: 51 N s}\n").arg(shape)
                             << *findPulseShape(shape);
    QTest::newRow("trapezoid")
        << "pulse: {shape: trapezoid, duration: 0.2 ms, impulse: 51 N s, rise: 0.1, fall: 0}\n"
        << PulseShape::trapezoid;
    QTest::newRow("piston")
        << "pulse:\n  shape: piston\n  length: 0.5 m\n  diameter: 45 mm\n  velocity: 10 m/s\n"
           "  youngs_modulus: 200 GPa\n  density: 7.8 g/cm^3\n"
        << PulseShape::piston;
    QTest::newRow("table")
        << "pulse:\n  shape: table\n  points: [[0 us, 0 kN], [0.1 ms, 500 kN], [200 us, 0 N]]\n"
        << PulseShape::table;
    QTest::newRow("table, block style")
        << "pulse:\n  shape: table\n  points:\n  - [0 us, 0 kN]\n  -\n    - 200 us\n    - 500 kN\n"
        << PulseShape::table;
}

void TestScenarioFile::everyShapeIsRead() {
    QFETCH(QString, pulse);
    QFETCH(PulseShape, shape);
    const std::string text = rodWithPulse(pulse.toStdString());
    const ScenarioDocument document = parsed(text);
    QVERIFY(document.scenario.pulse.shape == shape);
    QVERIFY(pulseDuration(document.scenario) > 1e-4 && pulseDuration(document.scenario) < 3e-4);
    compareText(writeScenario(document), text);
}

void TestScenarioFile::optionalValuesHaveTheirDefaults() {
    const Scenario scenario = parsed(R"(drillwave: 1
rod: {length: 1 m, diameter: 30 mm, youngs_modulus: 200 GPa, density: 7800 kg/m^3}
pulse: {shape: trapezoid, duration: 100 us, impulse: 20 N s}
bit_rock: {stiffness: 1 GN/m, gamma: 1}
)")
                                  .scenario;
    QCOMPARE(scenario.rod.bore, 0.0);
    QCOMPARE(scenario.pulse.rise, 0.2);
    QCOMPARE(scenario.pulse.fall, 0.3);
    QCOMPARE(scenario.bitRock.gap, 0.0);
    QVERIFY(scenario.drill == Drill());
    QVERIFY(scenario.title.empty());
    const Scenario bare =
        parsed("drillwave: 1\ndimensionless: {beta: 1, gamma: 1, tau: 1}\npulse: {shape: rigid_body}")
            .scenario;
    QCOMPARE(bare.groups.delta, 0.0);
}

void TestScenarioFile::anAreaReplacesTheDiameter() {
    const std::string text =
        replaced(replaced(t38, "  bore: 14.5 mm                   # optional flushing hole, default 0\n", ""),
                 "diameter: 38 mm", "area: 1134 mm^2");
    const ScenarioDocument document = parsed(text);
    QCOMPARE(document.scenario.rod.area.value(), 1134e-6);
    compareText(writeScenario(document), text);
}

void TestScenarioFile::aMeanForceIsReadAndKept() {
    const std::string text = replaced(t38, "impulse: 51 N s ", "force: 255 kN   ");
    ScenarioDocument document = parsed(text);
    QVERIFY(document.scenario.pulse.impulseFromForce);
    QCOMPARE(document.scenario.pulse.impulse, 255e3 * 200e-6);
    compareText(writeScenario(document), text);
    QCOMPARE(QString::fromStdString(assignText(document.scenario, "pulse.duration", "100 us").text()),
             QString());
    compareText(writeScenario(document), replaced(text, "200 us                # t0", "100 us"));
}

void TestScenarioFile::aTableFileIsReadBesideTheScenario() {
    QTemporaryDir folder;
    writeFile(folder.filePath("blow.csv"),
              "# measured\r\ntime [us],force [kN]\r\n10,0\r\n60,500\r\n\r\n210,0\r\n");
    writeFile(folder.filePath("case.yaml"),
              QByteArray::fromStdString(rodWithPulse("pulse: {shape: table, file: blow.csv}\n")));
    const ScenarioDocument document = loadScenario(folder.filePath("case.yaml").toStdString());
    const std::vector<TablePoint> expected{{10e-6, 0}, {60e-6, 500e3}, {210e-6, 0}};
    QVERIFY(document.scenario.pulse.tablePoints == expected);
    compareText(document.scenario.pulse.tableFile, "blow.csv");
}

void TestScenarioFile::tableFilesAreReadAsRecordsAre_data() {
    QTest::addColumn<QByteArray>("table");
    QTest::newRow("spreadsheet") << QByteArray("Time (us),Force (kN)\r\n10,0\r\n60,500\r\n210,0\r\n");
    QTest::newRow("force first") << QByteArray("force [kN],time [us]\n0,10\n500,60\n0,210\n");
    QTest::newRow("German") << QByteArray(
        "Zeit [\xB5s];Kraft [kN]\r\n10,0;0,0\r\n60,0;500,0\r\n210,0;0,0\r\n");
    QTest::newRow("further columns") << QByteArray(
        "n,time [us],T [K],F [kN]\n1,10,300,0\n2,60,301,500\n3,210,302,0\n");
}

void TestScenarioFile::tableFilesAreReadAsRecordsAre() {
    QFETCH(QByteArray, table);
    QTemporaryDir folder;
    writeFile(folder.filePath("blow.csv"), table);
    writeFile(folder.filePath("case.yaml"),
              QByteArray::fromStdString(rodWithPulse("pulse: {shape: table, file: blow.csv}\n")));
    const ScenarioDocument document = loadScenario(folder.filePath("case.yaml").toStdString());
    const std::vector<TablePoint> expected{{10e-6, 0}, {60e-6, 500e3}, {210e-6, 0}};
    QVERIFY(document.scenario.pulse.tablePoints == expected);
}

void TestScenarioFile::aTableFileIsWrittenBackByItsName() {
    QTemporaryDir folder;
    writeFile(folder.filePath("blow.csv"), "time,force\n0,1\n1,1\n");
    const std::string text =
        "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 1, tau: 10}\npulse: {shape: table, file: "
        "blow.csv}\n";
    writeFile(folder.filePath("case.yaml"), QByteArray::fromStdString(text));
    ScenarioDocument document = loadScenario(folder.filePath("case.yaml").toStdString());
    // The saved text does not depend on whether the table is still there.
    QVERIFY(QFile::remove(folder.filePath("blow.csv")));
    compareText(writeScenario(document), text);
    document.scenario.groups.beta = 0.7;
    compareText(writeScenario(document), replaced(text, "0.5", "0.7"));
}

void TestScenarioFile::problemsOfATableFileHaveItsLines_data() {
    QTest::addColumn<QByteArray>("csv");
    QTest::addColumn<QString>("problem");
    QTest::newRow("empty") << QByteArray() << "blow.csv:1:1: holds no header";
    QTest::newRow("no units") << QByteArray("time,force\n0,1\n1,1\n") << "blow.csv:1:1: `time` (needs a unit";
    QTest::newRow("wrong unit") << QByteArray("time [us],force [mm]\n0,1\n1,1\n")
                                << "blow.csv:1:1: `force [mm]`";
    QTest::newRow("no header") << QByteArray("0,0\n1,1\n") << "blow.csv:1:1: the header must be";
    QTest::newRow("two forces") << QByteArray("time [us],A [kN],B [kN]\n0,1,1\n1,1,1\n")
                                << "blow.csv:1:1: several columns could be the force";
    QTest::newRow("strain") << QByteArray("time [us],A [microstrain]\n0,1\n1,1\n")
                            << "blow.csv:1:1: `A [microstrain]` is not a force";
    QTest::newRow("word") << QByteArray("time [us],force [kN]\n0,1\n1,2\n2,much\n")
                          << "blow.csv:4:1: column 2: `much` is not a number";
    QTest::newRow("nan") << QByteArray("time [us],force [kN]\n0,1\n1,2\nnan,1\n")
                         << "blow.csv:4:1: column 1 holds no value (`nan`)";
    QTest::newRow("backwards") << QByteArray("time [us],force [kN]\n0,1\n2,1\n1,1\n")
                               << "blow.csv:4:1: the time 1 us is not later";
    QTest::newRow("pulling") << QByteArray("time [us],force [kN]\n0,1\n2,-1\n")
                             << "blow.csv:3:1: point 2 has a negative force";
    QTest::newRow("one row") << QByteArray("time [us],force [kN]\n0,1\n")
                             << "blow.csv:2:1: fewer than two samples";
    QTest::newRow("open quote") << QByteArray("time [us],force [kN]\n0,1\n1,2\n\"2,1\n")
                                << "blow.csv:4:1: column 2 is missing";
    QTest::newRow("binary") << QByteArray("time [us],force [kN]\n\0\1", 23) << "blow.csv:1:1: is not text";
}

void TestScenarioFile::problemsOfATableFileHaveItsLines() {
    QFETCH(QByteArray, csv);
    QFETCH(QString, problem);
    QTemporaryDir folder;
    writeFile(folder.filePath("blow.csv"), csv);
    writeFile(folder.filePath("case.yaml"),
              QByteArray::fromStdString(rodWithPulse("pulse: {shape: table, file: blow.csv}\n")));
    try {
        loadScenario(folder.filePath("case.yaml").toStdString());
        QFAIL("the table was accepted");
    } catch (const ScenarioError& error) {
        QVERIFY2(QString::fromStdString(error.lines().front()).contains(problem), error.what());
    }
}

void TestScenarioFile::theUsersLocaleChangesNothing() {
    struct CommaPoint : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
    ScenarioDocument document = parsed(t38);
    document.scenario.rod.density = 7850.5;
    const std::string text = writeScenario(document);
    std::locale::global(before);
    QCOMPARE(document.scenario.rod.length, 3.66);
    compareText(text, replaced(t38, "7850 kg", "7850.5 kg"));
}

QTEST_APPLESS_MAIN(TestScenarioFile)
#include "tst_scenario_file.moc"
