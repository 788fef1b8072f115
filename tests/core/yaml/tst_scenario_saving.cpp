// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario files as they are saved: nothing moves that did not change, and all reads back the same.
#include <QTest>

#include <cmath>
#include <random>

#include "core/model/parameter.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"
#include "tests/support/commented_scenario.h"
#include "tests/support/scenario_texts.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

class TestScenarioSaving : public QObject {
    Q_OBJECT

  private slots:
    void anythingUnchangedIsSavedByteForByte_data();
    void anythingUnchangedIsSavedByteForByte();
    void aChangedValueIsExchangedInItsUnit();
    void aCommentGoesWithItsValueWhateverTheLineEnds();
    void aChangedGroupIsExchangedInItsPlace();
    void aTitleIsExchangedAndQuotedWhereNeeded_data();
    void aTitleIsExchangedAndQuotedWhereNeeded();
    void aNewValueIsPutWhereItBelongs();
    void aValueThatWentIsTakenOut();
    void aYieldStrengthIsOptionalAndKept();
    void aNewSectionIsAppended();
    void aSectionThatWentIsTakenOut();
    void anotherShapeExchangesItsKeys();
    void listsArePutInAndEveryOtherCommentStays();
    void anItemOfAListIsPutInAmongLinesThatStay();
    void aSectionThatCannotBePatchedIsWrittenAnewByItself();
    void linesOfRandomEditsThatNobodyTouchedStayByteForByte();
    void anotherFormIsWrittenAnewBelowTheExplanation();
    void windowsLineEndsAndByteOrderMarkSurviveAChange();
    void aNewScenarioIsWrittenInItsCustomaryForm();
    void everyNewScenarioReadsBackTheSame();
    void randomEditsReadBackTheSame();
    void pointsThatDoNotFitIntoAFileAreRefused();
};

void TestScenarioSaving::anythingUnchangedIsSavedByteForByte_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("T38 of the contract") << t38;
    QTest::newRow("Fig. 4 (b) of the contract") << figure4b;
    QTest::newRow("no last line end") << QString(figure4b).trimmed();
    QTest::newRow("document marks") << "%YAML 1.2\n---\n" + QString(figure4b) + "...\n";
    QTest::newRow("byte order mark") << QString("\ufeff") + figure4b;
    QTest::newRow("Windows line ends") << QString(t38).replace("\n", "\r\n");
    QTest::newRow("quoted values")
        << QString(t38).replace("3.66 m", "\"3.66 m\"").replace("38 mm", "'38 mm'");
    QTest::newRow("all in braces") << "{drillwave: 1, dimensionless: {beta: 5e-1, gamma: 1.0, tau: 10.}, "
                                      "pulse: {shape: piston, impedance_ratio: 2}}";
    QTest::newRow("numbers as nobody writes them") << QString(figure4b).replace("0.5", "+0.50000e0");
    QTest::newRow("title over several lines")
        << QString(figure4b).replace("Fig. 4 (b) of the paper", "|\n  Fig.\n  4");
    QTest::newRow("empty title and drill")
        << QString(t38).left(QString(t38).indexOf("drill:  ")).replace("T38 rod, medium rock", "") +
               "drill:\n";
}

void TestScenarioSaving::anythingUnchangedIsSavedByteForByte() {
    QFETCH(QString, text);
    compareText(writeScenario(parsed(text.toStdString())), text.toStdString());
}

void TestScenarioSaving::aChangedValueIsExchangedInItsUnit() {
    ScenarioDocument document = parsed(t38);
    document.scenario.rod.length = 4.2;
    document.scenario.rod.diameter = 0.0381;
    document.scenario.drill.thrust = 9500;
    // A comment behind a value was about the value that was there; all others stay.
    std::string expected = replaced(t38, "3.66 m", "4.2 m");
    expected = replaced(expected, "38 mm                 # or  area: 1134 mm^2", "38.1 mm");
    compareText(writeScenario(document),
                replaced(expected, "8 kN                    # installed feed force", "9.5 kN"));
    document.scenario = parsed(t38).scenario;
    document.scenario.pulse.duration = 200e-6 / 3;
    document.scenario.bitRock.stiffness = 1e8 / 3;
    expected = replaced(t38, "200 us                # t0", "66.66666666666667 us");
    compareText(writeScenario(document),
                replaced(expected, "105 MN/m             # k, primary loading", "33.333333333333332 MN/m"));
}

void TestScenarioSaving::aCommentGoesWithItsValueWhateverTheLineEnds() {
    std::string text =
        "drillwave: 1\r\ndimensionless: {beta: 0.5, gamma: 1, tau: 10, delta: 0}  # groups\r\n"
        "pulse:\r\n  # how it strikes\r\n  shape: trapezoid  # a trapezoid\r\n"
        "  rise: 0.1\t# steep\r\n  fall: 0.3 # slow";
    ScenarioDocument document = parsed(text);
    document.scenario.pulse.rise = 0.2;
    document.scenario.pulse.fall = 0.4;
    document.scenario.groups.beta = 0.7;
    std::string expected = replaced(text, "0.1\t# steep\r\n", "0.2\r\n");
    expected = replaced(expected, "0.3 # slow", "0.4");
    compareText(writeScenario(document), replaced(expected, "beta: 0.5", "beta: 0.7"));
}

void TestScenarioSaving::aChangedGroupIsExchangedInItsPlace() {
    ScenarioDocument document = parsed(figure4b);
    document.scenario.groups = {.beta = 1e-7, .gamma = 1, .tau = 12.5, .delta = 0.521};
    compareText(writeScenario(document), replaced(figure4b, "{beta: 0.5, gamma: 0.1, tau: 10, delta: 0}",
                                                  "{beta: 1e-7, gamma: 1, tau: 12.5, delta: 0.521}"));
}

void TestScenarioSaving::aTitleIsExchangedAndQuotedWhereNeeded_data() {
    QTest::addColumn<QString>("title");
    QTest::addColumn<QString>("written");
    QTest::newRow("plain") << "Harder rock"
                           << "Harder rock";
    QTest::newRow("umlauts") << "Schlagbohren für Anfänger"
                             << "Schlagbohren für Anfänger";
    QTest::newRow("colon") << "rock: hard"
                           << "\"rock: hard\"";
    QTest::newRow("number sign") << "case #3"
                                 << "\"case #3\"";
    QTest::newRow("no comment") << "case#3"
                                << "case#3";
    QTest::newRow("quotes") << "\"hard\" rock"
                            << R"("\"hard\" rock")";
    QTest::newRow("backslash") << "C:\\drill"
                               << "C:\\drill";
    QTest::newRow("leading dash") << "- hard"
                                  << "\"- hard\"";
    QTest::newRow("null") << "null"
                          << "\"null\"";
    QTest::newRow("trailing blank") << "rock "
                                    << "\"rock \"";
    QTest::newRow("two lines") << "rock\nhard"
                               << R"("rock\nhard")";
    QTest::newRow("tab") << "rock\thard"
                         << R"("rock\x09hard")";
    QTest::newRow("alias") << "*rock"
                           << "\"*rock\"";
}

void TestScenarioSaving::aTitleIsExchangedAndQuotedWhereNeeded() {
    QFETCH(QString, title);
    QFETCH(QString, written);
    ScenarioDocument document = parsed(figure4b);
    document.scenario.title = title.toStdString();
    const std::string text = writeScenario(document);
    compareText(text, replaced(figure4b, "Fig. 4 (b) of the paper", written.toStdString()));
    compareText(parsed(text).scenario.title, title.toStdString());
}

void TestScenarioSaving::aNewValueIsPutWhereItBelongs() {
    std::string text =
        replaced(t38, "  bore: 14.5 mm                   # optional flushing hole, default 0\n", "");
    ScenarioDocument document = parsed(text);
    document.scenario.rod.bore = 0.0145;
    compareText(writeScenario(document), replaced(text, "  youngs", "  bore: 14.5 mm\n  youngs"));

    text = replaced(figure4b, ", delta: 0}", "}");
    document = parsed(text);
    document.scenario.groups.delta = 0.25;
    compareText(writeScenario(document), replaced(text, "tau: 10}", "tau: 10, delta: 0.25}"));

    text = replaced(figure4b, "title: Fig. 4 (b) of the paper\n", "");
    document = parsed(text);
    document.scenario.title = "New";
    compareText(writeScenario(document), replaced(text, "drillwave: 1\n", "drillwave: 1\ntitle: New\n"));

    // behind a value that stands below its key
    const std::string below = replaced(text, "drillwave: 1\n", "drillwave:\n  1\n");
    document = parsed(below);
    document.scenario.title = "New";
    compareText(writeScenario(document),
                replaced(below, "drillwave:\n  1\n", "drillwave:\n  1\ntitle: New\n"));
}

void TestScenarioSaving::aValueThatWentIsTakenOut() {
    ScenarioDocument document = parsed(t38);
    document.scenario.drill.blowFrequency.reset();
    document.scenario.title.clear();
    std::string expected = replaced(t38, "  blow_frequency: 60 Hz\n", "");
    expected = replaced(expected, "title: T38 rod, medium rock       # optional\n", "");
    compareText(writeScenario(document), expected);
}

void TestScenarioSaving::aYieldStrengthIsOptionalAndKept() {
    ScenarioDocument document = parsed(t38);
    QVERIFY(!document.scenario.rod.yieldStrength);
    compareText(writeScenario(document), t38);
    document.scenario.rod.yieldStrength = 850e6;
    const std::string text =
        replaced(t38, "  density: 7850 kg/m^3\n", "  density: 7850 kg/m^3\n  yield_strength: 850 MPa\n");
    compareText(writeScenario(document), text);
    const ScenarioDocument again = parsed(text);
    QCOMPARE(again.scenario.rod.yieldStrength.value_or(0), 850e6);
    compareText(writeScenario(again), text);
}

void TestScenarioSaving::aNewSectionIsAppended() {
    const std::string text = std::string(t38).substr(0, std::string(t38).find("drill:  "));
    ScenarioDocument document = parsed(text);
    document.scenario.drill.thrust = 8000;
    compareText(writeScenario(document), text + "drill:\n  thrust: 8 kN\n");
}

void TestScenarioSaving::aSectionThatWentIsTakenOut() {
    ScenarioDocument document = parsed(t38);
    document.scenario.drill = {};
    compareText(writeScenario(document), std::string(t38).substr(0, std::string(t38).find("drill:  ")));
}

void TestScenarioSaving::anotherShapeExchangesItsKeys() {
    ScenarioDocument document = parsed(t38);
    document.scenario.pulse.shape = PulseShape::trapezoid;
    document.scenario.pulse.rise = 0.4;
    std::string expected = replaced(t38, "rectangular", "trapezoid");
    expected = replaced(expected, "# I0\n", "# I0\n  rise: 0.4\n");
    compareText(writeScenario(document), expected);

    document = parsed(t38);
    document.scenario.pulse.shape = PulseShape::piston;
    const std::string text = writeScenario(document);
    QVERIFY(parsed(text).scenario == withoutUnusedValues(document.scenario));
    QVERIFY2(text.find("shape: piston\n  length: 500 mm\n  diameter: 38 mm\n  velocity: 10 m/s\nbit_rock:") !=
                 std::string::npos,
             text.c_str());
    QVERIFY(text.find("or  area: 1134 mm^2") != std::string::npos);
}

// A file lost the comments behind all values when a blow or corners came in.
void TestScenarioSaving::listsArePutInAndEveryOtherCommentStays() {
    const std::string text =
        "# why\ndrillwave: 1\nrod:\n  length: 3.66 m  # 12 ft\n  diameter: 38 mm  # nominal\n"
        "  youngs_modulus: 210 GPa\n  density: 7850 kg/m^3  # steel\npulse:\n  shape: rectangular\n"
        "  duration: 200 us  # guess\n  impulse: 51 N s\nbit_rock:\n  stiffness: 105 MN/m  # from hole 7\n"
        "  gamma: 0.1\n  gap: 0 mm  # seated\n";
    ScenarioDocument document = parsed(text);
    Pulse& pulse = document.scenario.pulse;
    pulse = {};
    pulse.shape = PulseShape::table;
    pulse.tablePoints = {{0, 0}, {100e-6, 250e3}, {200e-6, 0}};
    std::string expected =
        replaced(text, "  shape: rectangular\n  duration: 200 us  # guess\n  impulse: 51 N s\n",
                 "  shape: table\n  points:\n    - [0 us, 0 kN]\n    - [100 us, 250 kN]\n"
                 "    - [200 us, 0 kN]\n");
    compareText(writeScenario(document), expected);
    // Other points take the place of these.
    ScenarioDocument again = parsed(expected);
    again.scenario.pulse.tablePoints = {{0, 0}, {50e-6, 300e3}, {200e-6, 0}};
    expected = replaced(expected, "[100 us, 250 kN]", "[50 us, 300 kN]");
    compareText(writeScenario(again), expected);
    // And corners, into a section in one line, too.
    again.scenario.bitRock.law = RockLaw::corners;
    again.scenario.bitRock.corners = {{90e3, 0.35}};
    expected += "  law: corners\n  corners:\n    - {force: 90 kN, slope: 0.35}\n";
    compareText(writeScenario(again), expected);
}

// A rod more, and a file lost every comment.
void TestScenarioSaving::anItemOfAListIsPutInAmongLinesThatStay() {
    const std::string text =
        "drillwave: 2\nmaterial: {youngs_modulus: 210 GPa, density: 7850 kg/m^3}  # steel\n"
        "hammer:\n  velocity: 10 m/s  # measured\n  sections:\n    # weighed\n"
        "    - {length: 300 mm, diameter: 50 mm}  # piston\nstring:\n"
        "  - {name: adapter, length: 450 mm, diameter: 45 mm}  # worn\n"
        "  # three rods\n  - repeat: 3  # as drilled\n    of:\n"
        "      - {name: rod, length: 3660 mm, diameter: 39 mm}  # new\n"
        "  - name: bit  # with inserts\n    length: 60 mm\n    diameter: 76 mm  # gauge\n"
        "bit_rock: {stiffness: 100 MN/m, gamma: 0.1, gap: 0 mm}  # granite\n";
    ScenarioDocument document = parsed(text);
    DrillString& drillString = document.scenario.drillString;
    StringPart coupling;
    coupling.sections = {piece("coupling", 0.19, 0.056)};
    drillString.parts.insert(drillString.parts.begin() + 1, coupling);
    drillString.parts[2].sections.push_back(piece("sleeve", 0.2, 0.055));
    drillString.hammer.sections.insert(drillString.hammer.sections.begin(), piece("", 0.1, 0.04));
    std::string expected = replaced(
        text, "  # three rods\n", "  - {name: coupling, length: 190 mm, diameter: 56 mm}\n  # three rods\n");
    expected =
        replaced(expected, "# new\n", "# new\n      - {name: sleeve, length: 200 mm, diameter: 55 mm}\n");
    expected = replaced(expected, "    - {length: 300",
                        "    - {length: 100 mm, diameter: 40 mm}\n    - {length: 300");
    // The comment above the first item stays above it.
    compareText(writeScenario(document), expected);

    drillString.parts.erase(drillString.parts.begin());
    drillString.parts.back().sections.front().length = 0.07;
    expected = replaced(expected, "  - {name: adapter, length: 450 mm, diameter: 45 mm}  # worn\n", "");
    compareText(writeScenario(document), replaced(expected, "length: 60 mm", "length: 70 mm"));
}

void TestScenarioSaving::aSectionThatCannotBePatchedIsWrittenAnewByItself() {
    const std::string text =
        "# why\ndrillwave: 1\ntitle: |  # on two lines\n  One\n  two\n# the rod\n"
        "rod: {length: 3.66 m, diameter: 38 mm, youngs_modulus: 210 GPa, density: 7850 kg/m^3}  # steel\n"
        "pulse: {shape: rectangular, duration: 200 us,  # guess\n  # of the maker\n"
        "  impulse: 51 N s}\nbit_rock:  # granite\n  stiffness: 105 MN/m  # from hole 7\n  gamma: 0.1\n";
    ScenarioDocument document = parsed(text);
    Pulse& pulse = document.scenario.pulse;
    pulse = {};
    pulse.shape = PulseShape::table;
    std::vector<TablePoint> points;
    for (int i = 0; i < 30; ++i) points.push_back({i * 1e-5, i % 29 == 0 ? 0 : 1e5 + i * 1e3});
    pulse.tablePoints = points;
    document.scenario.title = "Three";
    const std::string saved = writeScenario(document);
    QVERIFY(parsed(saved).scenario == withoutUnusedValues(document.scenario));
    const std::size_t begin = text.find("pulse:"), end = text.find("bit_rock:");
    const std::string before = replaced(text.substr(0, begin), "|  # on two lines\n  One\n  two", "Three");
    compareText(saved.substr(0, before.size()), before);
    compareText(saved.substr(saved.find("bit_rock:")), text.substr(end));
    QVERIFY2(saved.find("  # of the maker\npulse:\n  shape: table\n  points:\n    - [0 us, 0 kN]\n") !=
                 std::string::npos,
             saved.c_str());
}

// Each line has a comment of its own, so that it is known which of them an edit may touch.
void TestScenarioSaving::linesOfRandomEditsThatNobodyTouchedStayByteForByte() {
    std::mt19937_64 random(static_cast<std::uint64_t>(11 + seed()));
    const int edits = tries("DRILLWAVE_EDITS", 200, 1000);
    int kept = 0;
    for (int i = 0; i < edits; ++i) {
        CommentedScenario file(static_cast<CommentedScenario::Layout>(i % CommentedScenario::layouts),
                               random);
        for (int save = 0; save < 2; ++save) {
            for (std::size_t n = 1 + random() % 3; n > 0; --n) file.edit(random);
            const std::string before = file.document.text;
            const std::string text = writeScenario(file.document);
            const ScenarioDocument saved = parsed(text);
            QVERIFY2(saved.scenario == withoutUnusedValues(file.document.scenario), text.c_str());
            QVERIFY2(saved.design == file.document.design, text.c_str());
            std::size_t place = 0;
            for (const std::string& line : file.untouchedLines()) {
                const std::size_t at = text.find(line, place);
                QVERIFY2(at != std::string::npos, ("edit " + std::to_string(i) + " lost the line\n" + line +
                                                   "of\n" + before + "in\n" + text)
                                                      .c_str());
                place = at + line.size();
                ++kept;
            }
            file.reopen(saved);
        }
    }
    // Most lines of a file are touched by no edit, or this would test little.
    QVERIFY2(kept > edits * 20, qPrintable(QString::number(kept)));
}

void TestScenarioSaving::anotherFormIsWrittenAnewBelowTheExplanation() {
    ScenarioDocument document = parsed("# What to look at.\n\n" + std::string(t38));
    document.scenario.form = ScenarioForm::dimensionless;
    document.scenario.groups = {.beta = 0.5, .gamma = 0.1, .tau = 10, .delta = 0};
    document.scenario.title = "Fig. 4 (b) of the paper";
    compareText(writeScenario(document), "# What to look at.\n\n" + std::string(figure4b));
}

void TestScenarioSaving::windowsLineEndsAndByteOrderMarkSurviveAChange() {
    const QString text = QString("\ufeff") + QString(t38).replace("\n", "\r\n");
    ScenarioDocument document = parsed(text.toStdString());
    document.scenario.rod.length = 4.2;
    document.scenario.drill = {};
    QString expected = QString(text).replace("3.66 m", "4.2 m");
    compareText(writeScenario(document), expected.left(expected.indexOf("drill:  ")).toStdString());
    // And a section appended.
    document = parsed(writeScenario(document));
    document.scenario.drill.thrust = 1000;
    QVERIFY(QString::fromStdString(writeScenario(document)).endsWith("\r\ndrill:\r\n  thrust: 1 kN\r\n"));
}

void TestScenarioSaving::aNewScenarioIsWrittenInItsCustomaryForm() {
    std::string expected = plainT38;
    for (const char* part : {"title: T38\n", "  bore: 14.5 mm\n", "drill:\n  thrust: 8 kN\n"})
        expected = replaced(expected, part, "");
    compareText(writeScenario({Scenario(), "", ""}), expected);

    compareText(writeScenario({parsed(figure4b).scenario, "", ""}), figure4b);
    Scenario table = parsed(figure4b).scenario;
    table.pulse.shape = PulseShape::table;
    table.pulse.tablePoints = {{0, 0}, {0.1, 1}};
    compareText(writeScenario({table, "", ""}),
                replaced(figure4b, "pulse: {shape: rectangular}\n",
                         "pulse:\n  shape: table\n  points:\n    - [0, 0]\n    - [0.1, 1]\n"));
}

void TestScenarioSaving::everyNewScenarioReadsBackTheSame() {
    std::mt19937_64 random(6);
    for (int i = 0; i < 400; ++i) {
        Scenario scenario;
        if (i % 3 == 0) scenario.form = ScenarioForm::dimensionless;
        scenario.pulse.shape = static_cast<PulseShape>(i % 8);
        std::vector<TablePoint> points;
        for (int n = 0; n < 20; ++n) points.push_back({n * 1.1e-5 / 3, 1e5 / (n + 1)});
        if (scenario.pulse.shape == PulseShape::table) scenario.pulse.tablePoints = std::move(points);
        for (const Parameter& parameter : parameters()) {
            // The groups of a dimensional scenario would only move what was set before.
            if (!isGiven(parameter, scenario) || parameter.key == "rod.area" || random() % 3 == 0) continue;
            std::uniform_real_distribution<double> plausible(parameter.plausible.low,
                                                             parameter.plausible.high);
            const double value = parameter.key == "pulse.fall" ? 0.1 : plausible(random);
            parameter.assign(scenario, parameter.rules.wholeNumber ? std::round(value) : value);
        }
        if (i % 5 == 0 && scenario.form == ScenarioForm::dimensional) scenario.rod.area = 1e-3 / 3;
        if (scenario.rod.bore >= scenario.rod.diameter) scenario.rod.bore = 0;
        if (scenario.drill.settle >= scenario.drill.blows) scenario.drill.settle.reset();
        if (scenario.pulse.rise + scenario.pulse.fall > 1)
            scenario.pulse.rise = scenario.pulse.fall = 1.0 / 3;
        const std::vector<InputProblem> problems = validate(scenario);
        QVERIFY2(problems.empty(), problems.empty() ? "" : problems.front().text.text().c_str());
        const std::string text = writeScenario({scenario, "", ""});
        QVERIFY2(parsed(text).scenario == withoutUnusedValues(scenario), text.c_str());
    }
}

void TestScenarioSaving::randomEditsReadBackTheSame() {
    std::mt19937_64 random(7);
    for (const char* base : {t38, figure4b}) {
        for (int i = 0; i < 300; ++i) {
            ScenarioDocument document = parsed(base);
            for (int edit = 0; edit < 3; ++edit) {
                const Parameter& parameter = parameters()[random() % parameters().size()];
                std::uniform_real_distribution<double> plausible(parameter.plausible.low,
                                                                 parameter.plausible.high);
                if (parameter.applies(document.scenario))
                    parameter.assign(document.scenario, plausible(random));
                if (random() % 4 == 0) document.scenario.pulse.shape = static_cast<PulseShape>(random() % 6);
                if (random() % 6 == 0) document.scenario.title = edit == 0 ? "" : "t: " + std::to_string(i);
                if (random() % 6 == 0) document.scenario.drill = {};
            }
            if (!validate(document.scenario).empty()) continue;
            const std::string text = writeScenario(document);
            const ScenarioDocument saved = parsed(text);
            QVERIFY2(saved.scenario == withoutUnusedValues(document.scenario), text.c_str());
            compareText(writeScenario(saved), text);
        }
    }
}

void TestScenarioSaving::pointsThatDoNotFitIntoAFileAreRefused() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::table;
    std::vector<TablePoint> points;
    for (int i = 0; i < 80000; ++i) points.push_back({i * 1e-9 / 3, 1e5 / (i + 1)});
    scenario.pulse.tablePoints = std::move(points);
    QVERIFY_EXCEPTION_THROWN(writeScenario({scenario, "", ""}), ScenarioError);
}

QTEST_APPLESS_MAIN(TestScenarioSaving)
#include "tst_scenario_saving.moc"
