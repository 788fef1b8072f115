// SPDX-License-Identifier: GPL-3.0-or-later
// Presets: what is built in is sound and sourced, and what users add is read as strictly as a scenario.
#include <QTest>

#include <algorithm>
#include <map>
#include <set>

#include "core/model/alerts.h"
#include "core/model/law_parameter.h"
#include "core/report/alert_words.h"
#include "core/yaml/examples.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/yaml_tree.h"
#include "tests/support/scenario_texts.h"

using namespace drillwave;

namespace {

const std::string good = R"(drillwave_presets: 1
rods:
  - name: mine
    diameter: [40 mm, measured]
    bore: [15 mm, measured]
hammers:
  - name: my drill
    shape: [piston, data sheet]
    length: [500 mm, data sheet]
    diameter: [40 mm, data sheet]
    velocity: [9 m/s, assumed]
    blow_frequency: [50 Hz, data sheet]
rocks:
  - name: my quarry
    stiffness: [120 MN/m, fitted]
    gamma: [0.2, fitted]
  - name: my layers
    stiffness: [250 MN/m, fitted]
    gamma: [0.15, fitted]
    law: [corners, drop test]
    corners: [[{force: 90 kN, slope: 0.35}, {force: 150 kN, slope: 0.2}], fitted]
  - name: my powder
    stiffness: [80 MN/m, fitted]
    gamma: [0.1, fitted]
    law: [power, fitted]
    exponent: [1.5, handbook]
    reference_penetration: [0.5 mm, fitted]
)";

std::string with(const std::string& from, const std::string& to) {
    return test::replaced(good, from, to);
}

const Preset& preset(std::string_view name) {
    return *std::ranges::find(builtInPresets(), name, &Preset::name);
}

}  // namespace

class TestPresetFile : public QObject {
    Q_OBJECT

  private slots:
    void everyBuiltInValueHasAUnitAndASource();
    void everyBuiltInPresetGivesAValidScenario_data();
    void everyBuiltInPresetGivesAValidScenario();
    void aPresetSetsWhatItNamesAndNothingElse();
    void aPresetMatchesWhereTakingItWouldChangeNothing();
    void everyRodHasStrengthsThatAreAssumedOrHaveASource();
    void everyPieceOfAStringHasAssumedStrengths();
    void aPresetMatchesUntilOneOfItsValuesChanges();
    void aHammerWithoutAMaterialHasTheRods();
    void presetsNeverMatchGroupsAlone();
    void aFileOfTheUserIsRead();
    void aRockHasItsLoadingCurve();
    void aCurveMatchesUntilItChanges();
    void aRockThatSaysNothingOfItsLawIsBilinear();
    void theCurveLeavesItsSourceInTheFile();
    void problemsAreReportedAtTheirPlace_data();
    void problemsAreReportedAtTheirPlace();
    void allProblemsAreReportedAtOnce();
    void aMissingFileIsReported();
    void everyPieceOfAStringFitsIntoOne();
    void piecesOfStringsAreRead();
};

void TestPresetFile::everyBuiltInValueHasAUnitAndASource() {
    QFile file(QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/presets/presets.yaml"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const std::string text = file.readAll().toStdString();
    QCOMPARE(parsePresets(text, "presets.yaml").presets.size(), builtInPresets().size());
    // Looked at without the reader that enforces it.
    const YamlTree tree = parseYaml(text);
    int values = 0;
    for (std::size_t list = 3; list <= 7; list += 2)  // rods, hammers, rocks
        for (const YamlNode& item : tree.root.children[list].children)
            for (std::size_t i = 0; i + 1 < item.children.size(); i += 2) {
                const std::string& key = item.children[i].text;
                if (key == "name") continue;
                const YamlNode& pair = item.children[i + 1];
                QCOMPARE(pair.children.size(), std::size_t(2));
                QVERIFY2(pair.children[1].text.size() > 4, key.c_str());
                if (key != "shape" && key != "gamma")
                    QVERIFY2(pair.children[0].text.find(' ') != std::string::npos, key.c_str());
                ++values;
            }
    QVERIFY(values > 50);
    for (const Preset& each : builtInPresets()) {
        QVERIFY(!each.shape || !each.shapeSource.empty());
        for (const PresetValue& value : each.values) QVERIFY(!value.source.empty());
    }
}

void TestPresetFile::everyBuiltInPresetGivesAValidScenario_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Preset& each : builtInPresets()) QTest::newRow(each.name.c_str()) << index++;
}

void TestPresetFile::everyBuiltInPresetGivesAValidScenario() {
    QFETCH(int, index);
    const Preset& each = builtInPresets()[static_cast<std::size_t>(index)];
    const Scenario scenario = withPreset({}, each);
    QVERIFY(validate(scenario).empty());
    for (const Alert& alert : alertsFor(scenario))
        QVERIFY2(alert.code != AlertCode::implausibleValue, alertText(alert).c_str());
    QVERIFY(matches(each, scenario));
    QVERIFY(!description(each, plainStyle()).empty());
    // No two presets of a kind are the same under two names.
    QCOMPARE(std::ranges::count_if(
                 builtInPresets(),
                 [&](const Preset& other) { return other.kind == each.kind && matches(other, scenario); }),
             1);
}

void TestPresetFile::aPresetSetsWhatItNamesAndNothingElse() {
    Scenario scenario;
    scenario.title = "kept";
    scenario.rod.length = 6.1;
    scenario.rod.area = 1e-3;
    const Scenario after = withPreset(scenario, preset("T45, round 46 mm"));
    Scenario expected = scenario;
    expected.rod.area.reset();
    expected.rod.diameter = 0.046;
    expected.rod.bore = 0.017;
    expected.rod.yieldStrength = 900e6;
    expected.rod.fatigueStrength = 400e6;
    QVERIFY(after == expected);
}

void TestPresetFile::aPresetMatchesWhereTakingItWouldChangeNothing() {
    int matching = 0;
    const auto compare = [&](const Scenario& scenario) {
        for (const Preset& each : builtInPresets()) {
            const bool unchanged = withPreset(scenario, each) == scenario;
            QCOMPARE(matches(each, scenario), unchanged);
            matching += unchanged;
        }
    };
    for (const Preset& each : builtInPresets()) {
        const Scenario scenario = withPreset({}, each);
        compare(scenario);
        for (const Parameter& parameter : parameters()) {
            if (!parameter.applies(scenario)) continue;
            Scenario same = scenario;
            if (const auto value = parameter.value(scenario)) parameter.assign(same, *value);
            compare(same);
            Scenario other = scenario;
            parameter.assign(other, 1.01 * parameter.value(scenario).value_or(parameter.plausible.high));
            compare(other);
        }
    }
    QVERIFY2(matching > 500, qPrintable(QString::number(matching)));
}

void TestPresetFile::everyRodHasStrengthsThatAreAssumedOrHaveASource() {
    for (const Preset& each : builtInPresets()) {
        if (each.kind != PresetKind::rod) continue;
        const Scenario scenario = withPreset({}, each);
        QVERIFY(scenario.rod.yieldStrength && scenario.rod.fatigueStrength);
        QVERIFY(*scenario.rod.fatigueStrength < *scenario.rod.yieldStrength);
    }
}

void TestPresetFile::everyPieceOfAStringHasAssumedStrengths() {
    for (const SectionPreset& each : builtInSectionPresets()) {
        for (const Section& section : each.sections) QCOMPARE(section.preset, each.name);
        if (each.kind == SectionPresetKind::piston) continue;
        QVERIFY2(each.strengthSource.starts_with("assumed: ") &&
                     each.strengthSource.find("steel") != std::string::npos &&
                     each.strengthSource.find("notch factor") != std::string::npos,
                 each.name.c_str());
        for (const Section& section : each.sections)
            QVERIFY2(section.yieldStrength == 900e6 && section.fatigueStrength == 400e6 / 1.6,
                     each.name.c_str());
        QVERIFY(description(each, plainStyle()).find("fatigue strength 250 MPa — assumed") !=
                std::string::npos);
    }
}

void TestPresetFile::aPresetMatchesUntilOneOfItsValuesChanges() {
    Scenario scenario = withPreset({}, preset("R32, hex 32 mm"));
    QVERIFY(matches(preset("R32, hex 32 mm"), scenario));
    scenario.rod.length = 1.83;
    QVERIFY(matches(preset("R32, hex 32 mm"), scenario));
    scenario.rod.area = 8e-4;
    QVERIFY(!matches(preset("R32, hex 32 mm"), scenario));
}

void TestPresetFile::aHammerWithoutAMaterialHasTheRods() {
    Scenario scenario;
    scenario.pulse.piston.density = 2700;
    QVERIFY(!withPreset(scenario, preset("heavy drifter, piston")).pulse.piston.density);
}

void TestPresetFile::presetsNeverMatchGroupsAlone() {
    Scenario scenario = withPreset({}, preset("medium rock"));
    scenario.form = ScenarioForm::dimensionless;
    QVERIFY(!matches(preset("medium rock"), scenario));
}

void TestPresetFile::aFileOfTheUserIsRead() {
    const std::vector<Preset> presets = parsePresets(good, "mine.yaml").presets;
    QCOMPARE(presets.size(), std::size_t(5));
    QCOMPARE(presets[1].name, std::string("my drill"));
    QVERIFY(presets[1].shape == PulseShape::piston);
    QCOMPARE(presets[1].values.size(), std::size_t(4));
    QCOMPARE(presets[1].values.back().parameter->key, std::string_view("drill.blow_frequency"));
    QCOMPARE(presets[1].values.back().si, 50.0);
    QCOMPARE(presets[2].values.front().source, std::string("fitted"));
    QVERIFY(description(presets[2], plainStyle()).starts_with("stiffness: 120 MN/m — fitted"));
    QVERIFY(parsePresets("drillwave_presets: 1\n", "").presets.empty());
}

void TestPresetFile::aRockHasItsLoadingCurve() {
    const std::vector<Preset> presets = parsePresets(good, "mine.yaml").presets;
    const Preset &layers = presets[3], &powder = presets[4];
    const Scenario corners = withPreset({}, layers);
    QVERIFY(corners.bitRock.law == RockLaw::corners);
    QCOMPARE(corners.bitRock.corners.size(), std::size_t(2));
    QCOMPARE(corners.bitRock.corners[1].force, 150e3);
    QCOMPARE(corners.bitRock.corners[1].slope, 0.2);
    QVERIFY(validate(corners).empty());
    QCOMPARE(description(layers, plainStyle()),
             std::string("loading curve: a law with corners, from 90 kN on slope 0.35, from 150 kN on slope "
                         "0.2 — drop test; corners: "
                         "fitted\nstiffness: 250 MN/m — fitted\nelasticity: 0.15 — fitted"));
    // From one law to another nothing of the first is left.
    const Scenario power = withPreset(corners, powder);
    QVERIFY(power.bitRock.law == RockLaw::power && power.bitRock.corners.empty());
    QCOMPARE(power.bitRock.exponent, 1.5);
    QCOMPARE(power.bitRock.referencePenetration, 0.5e-3);
    QVERIFY(withPreset(power, layers) == corners);
}

void TestPresetFile::aCurveMatchesUntilItChanges() {
    const Preset layers = parsePresets(good, "mine.yaml").presets[3];
    const Scenario taken = withPreset({}, layers);
    QVERIFY(matches(layers, taken));
    Scenario other = taken;
    other.bitRock.corners[1].slope = 0.3;
    QVERIFY(!matches(layers, other));
    other = taken;
    other.bitRock.corners.pop_back();
    QVERIFY(!matches(layers, other));
    other.bitRock = withLaw(taken.bitRock, RockLaw::bilinear);
    QVERIFY(!matches(layers, other));
}

void TestPresetFile::aRockThatSaysNothingOfItsLawIsBilinear() {
    const std::vector<Preset> presets = parsePresets(good, "mine.yaml").presets;
    const Scenario layers = withPreset({}, presets[3]);
    Scenario ofTheSameNumbers = layers;
    ofTheSameNumbers.bitRock.stiffness = 120e6;
    ofTheSameNumbers.bitRock.gamma = 0.2;
    QVERIFY(!matches(presets[2], ofTheSameNumbers));
    QVERIFY(withPreset(layers, presets[2]) == withPreset({}, presets[2]));
}

void TestPresetFile::theCurveLeavesItsSourceInTheFile() {
    const Preset layers = parsePresets(good, "mine.yaml").presets[3];
    ScenarioDocument document = parseScenario(findExample("t38_medium_rock")->text, "");
    document.scenario = withPreset(document.scenario, layers);
    const std::string text = writeWithPreset(document, layers);
    QVERIFY2(text.find("law: corners  # preset my layers: drop test; corners: fitted\n") != std::string::npos,
             text.c_str());
    QVERIFY(parseScenario(text, "").scenario == document.scenario);
}

void TestPresetFile::problemsAreReportedAtTheirPlace_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("line");
    const auto row = [](const char* name, const std::string& text, const char* line) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << QString(line);
    };
    row("no unit", with("[40 mm, measured]", "[40, measured]"),
        "mine.yaml:4:16: rod.diameter = 40 (has no unit");
    row("no source", with("[15 mm, measured]", "15 mm"), "mine.yaml:5:11: rod.bore (must be [value, source]");
    row("empty source", with("[15 mm, measured]", "[15 mm, \"\"]"), "mine.yaml:5:11: rod.bore (must be");
    row("unknown key", with("velocity:", "velocty:"),
        "mine.yaml:11:5: pulse.velocty (is not a known key, did you mean `velocity`?)");
    row("out of range", with("[0.2, fitted]", "[1.2, fitted]"),
        "mine.yaml:16:13: bit_rock.gamma = 1.2 (must be in (0, 1])");
    row("missing value", with("    gamma: [0.2, fitted]\n", ""), "bit_rock.gamma (is missing");
    row("missing name", with("- name: mine\n    diameter", "- diameter"),
        "mine.yaml:3:5: rods.name (is missing)");
    row("unknown shape", with("[piston, data sheet]", "[square, data sheet]"),
        "mine.yaml:8:13: pulse.shape = square (must be a shape");
    row("value of another shape", with("blow_frequency: [50 Hz, data sheet]", "rise: [0.2, assumed]"),
        "mine.yaml:12:5: pulse.rise (only for a trapezoid");
    row("bore wider than the rod", with("[15 mm, measured]", "[50 mm, measured]"),
        "mine.yaml:5:12: rod.bore = 50 mm (must be less than the diameter of 40 mm)");
    row("a name of two lines", with("name: mine\n    diameter", "name: \"mi\\nne\"\n    diameter"),
        "rods.name = mi ne (must be one line)");
    row("a name of blanks", with("name: mine\n    diameter", "name: \"  \"\n    diameter"),
        "rods.name =  (must have a letter)");
    row("a source without a letter", with("[15 mm, measured]", "[15 mm, \"...\"]"),
        "rod.bore = ... (the source must have a letter)");
    row("a source that turns the line", with("[15 mm, measured]", "[15 mm, \"\u202Emeasured\"]"),
        "(the source must have no characters that change the reading direction)");
    row("no such law", with("[power, fitted]", "[cubic, fitted]"),
        "mine.yaml:25:11: bit_rock.law = cubic (must be one of bilinear, corners, power)");
    row("corners of no law", with("    law: [corners, drop test]\n", ""),
        "bit_rock.corners (only for a law with corners");
    row("a law without its corners",
        with("    corners: [[{force: 90 kN, slope: 0.35}, {force: 150 kN, slope: 0.2}], fitted]\n", ""),
        "mine.yaml:17:5: bit_rock.corners (is missing");
    row("corners without a source", with("slope: 0.2}], fitted]", "slope: 0.2}]]"),
        "mine.yaml:21:14: bit_rock.corners (must be [value, source]");
    row("a force that does not grow", with("150 kN", "50 kN"),
        "bit_rock.corners.2.force = 50 kN (must be greater");
    row("a slope that creates energy", with("slope: 0.2", "slope: 7"),
        "bit_rock.corners.2.slope = 7 (must be at");
    row("a power law without its exponent", with("    exponent: [1.5, handbook]\n", ""),
        "bit_rock.exponent (is missing");
    row("an exponent of no power law", with("    law: [power, fitted]\n", ""),
        "bit_rock.exponent (only for a power law");
    row("no list", with("rods:\n  - name: mine\n    diameter", "rods:\n    diameter"),
        "rods (must be a list");
    row("other list", with("rocks:", "stones:"), "mine.yaml:13:1: stones (is not a known key");
    row("a scenario", "drillwave: 1\n", "mine.yaml:1:1: drillwave_presets (is missing");
    row("newer format", with("presets: 1", "presets: 2"), "this program reads the format 1");
    row("no yaml", "rods: [", "mine.yaml:1:");
    row("empty", "", "must begin with `drillwave_presets: 1`");
}

void TestPresetFile::problemsAreReportedAtTheirPlace() {
    QFETCH(QByteArray, text);
    QFETCH(QString, line);
    try {
        parsePresets(text.toStdString(), "mine.yaml");
        QFAIL("was read");
    } catch (const ScenarioError& error) {
        const std::string said = error.lines().front();
        QVERIFY2(said.find(line.toStdString()) != std::string::npos, said.c_str());
    }
}

void TestPresetFile::allProblemsAreReportedAtOnce() {
    std::string text = with("[40 mm, measured]", "[40, measured]");
    text.replace(text.find("[9 m/s, assumed]"), 16, "[9 m, assumed]  ");
    text.replace(text.find("[0.2, fitted]"), 13, "[2, fitted]");
    try {
        parsePresets(text, "mine.yaml");
        QFAIL("was read");
    } catch (const ScenarioError& error) {
        QCOMPARE(error.problems().size(), std::size_t(3));
    }
}

void TestPresetFile::aMissingFileIsReported() {
    try {
        loadPresets("/nowhere/presets.yaml");
        QFAIL("was read");
    } catch (const ScenarioError& error) {
        QVERIFY(error.kind() == ScenarioError::Kind::unreadable);
        QVERIFY(
            error.lines().front().starts_with("/nowhere/presets.yaml: the file of presets cannot be opened"));
    }
}

void TestPresetFile::everyPieceOfAStringFitsIntoOne() {
    std::map<SectionPresetKind, int> count;
    std::set<std::string> names;
    for (const SectionPreset& each : builtInSectionPresets()) {
        Scenario scenario = parseScenario(findExample("t38_string")->text, "").scenario;
        DrillString& drill = scenario.drillString;
        if (each.kind == SectionPresetKind::piston)
            drill.hammer = withPiston(drill.hammer, each);
        else
            drill.parts.push_back({.repeat = 1, .group = false, .sections = {each.sections.back()}});
        QVERIFY2(validate(scenario).empty(), each.name.c_str());
        for (const Alert& alert : alertsFor(scenario))
            QVERIFY2(alert.code != AlertCode::implausibleValue, alertText(alert).c_str());
        QVERIFY2(each.source.size() > 4, each.name.c_str());
        QVERIFY2(names.insert(each.name).second, each.name.c_str());
        QVERIFY(description(each, plainStyle()).find(each.source) != std::string::npos);
        ++count[each.kind];
    }
    for (const SectionPresetKind kind : sectionPresetKinds) QVERIFY(count[kind] >= 3);
}

void TestPresetFile::piecesOfStringsAreRead() {
    const std::string text = R"(drillwave_presets: 1
pistons:
  - name: mine
    source: data sheet
    velocity: 9 m/s
    sections:
      - {length: 300 mm, diameter: 50 mm}
      - {length: 0.25 m, diameter: 38 mm}
couplings:
  - {name: sleeve, source: measured, sections: [{name: coupling, length: 190 mm, diameter: 56 mm, bore: 40 mm, loss: 2 %}]}
)";
    const std::vector<SectionPreset> read = parsePresets(text, "mine.yaml").sectionPresets;
    QCOMPARE(read.size(), std::size_t(2));
    QCOMPARE(read[0].kind, SectionPresetKind::piston);
    QCOMPARE(*read[0].velocity, 9.0);
    QCOMPARE(read[0].sections.size(), std::size_t(2));
    QCOMPARE(read[1].sections[0].loss, 0.02);
    QCOMPARE(description(read[0], plainStyle()),
             std::string("300 mm × 50 mm, 250 mm × 38 mm, 9 m/s — data sheet"));
    for (const auto& [from, to, reason] : std::vector<std::tuple<std::string, std::string, std::string>>{
             {"bore: 40 mm", "bore: 60 mm", "couplings"},
             {"source: measured, ", "", "mine.yaml:10"},
             {"    velocity: 9 m/s\n", "    velocity: 9\n", "pistons.velocity"},
             {"length: 190 mm, ", "", "couplings.sections.1.length"},
             {"loss: 2 %", "loss: 2", "couplings.sections.1.loss"},
             {"source: measured", "source: \"?\"", "couplings.source = ? (must have a letter)"},
             {"name: sleeve", "name: \"a\\nb\"", "couplings.name = a b (must be one line)"},
             {"bore: 40 mm", "bore: 1e-9 m, mass_after: 1e12 kg", "couplings.sections.1.mass_after"},
             {"source: measured", "velocity: 3 m/s, source: x", "velocity"}}) {
        std::string wrong = text;
        wrong.replace(wrong.find(from), from.size(), to);
        try {
            parsePresets(wrong, "mine.yaml");
            QFAIL(reason.c_str());
        } catch (const ScenarioError& error) {
            QVERIFY2(error.lines().front().find(reason) != std::string::npos, error.lines().front().c_str());
        }
    }
}

QTEST_GUILESS_MAIN(TestPresetFile)
#include "tst_preset_file.moc"
