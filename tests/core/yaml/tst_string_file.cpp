// SPDX-License-Identifier: GPL-3.0-or-later
// Files of format 2: a hammer and a string of sections, read with every problem and saved again.
#include <QTest>

#include <random>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/model/section_field.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"
#include "tests/support/scenario_texts.h"

using namespace drillwave;
using test::replaced;

namespace {

/// As the manual has it (files §1.3).
constexpr const char* manualFile = R"(drillwave: 2
title: T38, three rods
material: {youngs_modulus: 210 GPa, density: 7850 kg/m^3}     # default of every section
hammer:
  velocity: 10 m/s
  sections:                                  # from the rear to the face
    - {length: 300 mm, diameter: 50 mm}
    - {length: 250 mm, diameter: 38 mm}
  face_stiffness: 10 GN/m                    # optional; a rigid face without it
  restrike: true                             # false: the hammer is withdrawn after the first separation
string:                                      # from the shank to the bit
  - {name: adapter, length: 450 mm, diameter: 45 mm, bore: 12 mm}
  - repeat: 3
    of:
      - {name: coupling, length: 190 mm, diameter: 56 mm, bore: 14.5 mm, loss: 2 %}    # in the joint
      - {name: rod, length: 3660 mm, diameter: 39 mm, bore: 14.5 mm, attenuation: 0.002 1/m, yield_strength: 900 MPa}
  - {name: bit skirt, length: 70 mm, diameter: 56 mm, bore: 14.5 mm}
  - {name: bit head, length: 60 mm, diameter: 76 mm, mass_after: 0.3 kg}               # lumped mass
bit_rock: {stiffness: 100 MN/m, gamma: 0.1, gap: 0 mm}
drill: {blow_frequency: 60 Hz, thrust: 8 kN}
)";

/// In lines of their own, with units of other countries.
constexpr const char* blockFile = R"(# Ours.
drillwave: 2
hammer:
  velocity: 30 ft/s   # measured
  sections:
  - length: 12 in     # rear
    area: 20 cm^2
string:
- name: rod           # the only one
  length: 10 ft
  diameter: 1.5 in
- repeat: 2
  of:
  - length: 100 mm
    diameter: 60 mm
    loss: 0.03
bit_rock:
  stiffness: 1 GN/m
  gamma: 1
)";

ScenarioDocument parsed(const std::string& text) {
    return parseScenario(text, "s.yaml");
}

QStringList problemsOf(const std::string& text) {
    try {
        parsed(text);
    } catch (const ScenarioError& error) {
        QStringList lines;
        for (const std::string& line : error.lines()) lines << QString::fromStdString(line);
        return lines;
    }
    return {};
}

void compareText(const std::string& text, const std::string& expected) {
    const QStringList lines = QString::fromStdString(text).split('\n');
    const QStringList wanted = QString::fromStdString(expected).split('\n');
    QCOMPARE(lines, wanted);
}

using Random = std::mt19937_64;

double between(const Range& range, Random& random) {
    return std::uniform_real_distribution<double>(range.low, range.high)(random);
}

Section randomSection(Random& random) {
    constexpr const char* names[] = {"",     "rod", "bit skirt", "a, b: c", "rod #1",
                                     "true", "- x", "Gestänge",  "{a}",     "a? b"};
    Section section;
    section.name = names[random() % std::size(names)];
    for (const SectionField& field : sectionFields())
        if (field.presence == Presence::required || field.presence == Presence::either || random() % 3 == 0)
            if (field.applies(section)) field.assign(section, between(field.plausible, random));
    if (section.bore >= std::min(section.diameter, section.endDiameter.value_or(section.diameter)))
        section.bore = 0;
    return section;
}

std::vector<Section> randomSections(Random& random) {
    std::vector<Section> sections;
    for (std::size_t n = 1 + random() % 4; n > 0; --n) sections.push_back(randomSection(random));
    return sections;
}

double plausibleValue(const Parameter& parameter, Random& random) {
    const double value = between(parameter.plausible, random);
    return parameter.rules.wholeNumber ? std::round(value) : value;
}

Scenario randomString(Random& random) {
    Scenario scenario;
    scenario.form = ScenarioForm::string;
    for (const Parameter& parameter : parameters())
        if (parameter.applies(scenario) && !parameter.isGroup() && random() % 2 == 0)
            parameter.assign(scenario, plausibleValue(parameter, random));
    DrillString& drillString = scenario.drillString;
    drillString.hammer.restrike = random() % 2 == 0;
    drillString.hammer.sections = randomSections(random);
    for (Section& section : drillString.hammer.sections) section.loss = section.attenuation = 0;
    drillString.hammer.sections.back().endDiameter.reset();
    drillString.hammer.sections.back().endArea.reset();
    for (std::size_t n = 1 + random() % 4; n > 0; --n) {
        if (random() % 2 == 0)
            drillString.parts.push_back({static_cast<int>(1 + random() % 5), true, randomSections(random)});
        else
            drillString.parts.push_back({1, false, {randomSection(random)}});
    }
    if (scenario.drill.settle >= scenario.drill.blows) scenario.drill.settle.reset();
    if (random() % 2 == 0) scenario.title = "Probe: " + std::to_string(random() % 100);
    return scenario;
}

}  // namespace

class TestStringFile : public QObject {
    Q_OBJECT

  private slots:
    void theFileOfTheManualIsRead();
    void whatIsNotGivenHasItsDefault();
    void wrongFilesAreRefusedWhereTheyAreWrong_data();
    void wrongFilesAreRefusedWhereTheyAreWrong();
    void everyProblemOfAFileIsToldAtOnce();
    void aForceStandsInPlaceOfTheHammer();
    void aForceIsRefusedWhereItIsNone();
    void repeatsAreCountedBeforeTheyAreWrittenOut();
    void aThousandSectionsAreAllowed();
    void anUnchangedFileIsSavedByteForByte();
    void aChangedValueIsPatchedInItsPlace();
    void aPartThatWentTakesOnlyItsLines();
    void aNewStringIsWrittenInItsCustomaryForm();
    void theNameOfAPresetIsKept();
    void everyNewStringReadsBackTheSame();
    void randomEditsReadBackTheSame();
};

void TestStringFile::theFileOfTheManualIsRead() {
    const Scenario scenario = parsed(manualFile).scenario;
    QVERIFY(scenario.form == ScenarioForm::string);
    const DrillString& drillString = scenario.drillString;
    QCOMPARE(drillString.hammer.velocity, 10.0);
    QCOMPARE(drillString.hammer.sections.size(), std::size_t(2));
    QCOMPARE(drillString.hammer.sections[1].diameter, 0.038);
    QCOMPARE(drillString.hammer.faceStiffness.value(), 10e9);
    QVERIFY(drillString.hammer.restrike);
    QCOMPARE(drillString.parts.size(), std::size_t(4));
    const StringPart& rods = drillString.parts[1];
    QVERIFY(rods.group && rods.repeat == 3);
    QCOMPARE(rods.sections[0].loss, 0.02);
    QCOMPARE(rods.sections[1].attenuation, 0.002);
    QCOMPARE(rods.sections[1].yieldStrength.value(), 900e6);
    QCOMPARE(drillString.parts[2].sections[0].name, std::string("bit skirt"));
    QCOMPARE(drillString.parts[3].sections[0].massAfter, 0.3);
    QCOMPARE(scenario.bitRock.stiffness, 100e6);
    QCOMPARE(scenario.drill.thrust.value(), 8e3);
    QCOMPARE(expandedSections(drillString).size(), std::size_t(9));
}

void TestStringFile::whatIsNotGivenHasItsDefault() {
    const Scenario scenario = parsed(blockFile).scenario;
    QVERIFY(scenario.drillString.material == Material());
    QVERIFY(scenario.drillString.hammer.restrike && !scenario.drillString.hammer.faceStiffness);
    QVERIFY(!scenario.drillString.endTime && scenario.bitRock.gap == 0);
    const Section& rod = scenario.drillString.parts[0].sections[0];
    QVERIFY(rod.bore == 0 && rod.loss == 0 && rod.massAfter == 0 && !rod.youngsModulus);
    QCOMPARE(scenario.drillString.parts[1].sections[0].loss, 0.03);  // a share may be a bare number
}

void TestStringFile::wrongFilesAreRefusedWhereTheyAreWrong_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* name, const char* from, const char* to, const char* problem) {
        QTest::newRow(name) << from << to << problem;
    };
    row("no unit", "length: 300 mm", "length: 300",
        "s.yaml:7:16: hammer.1.length = 300 (has no unit: write for");
    row("wrong unit", "bore: 12 mm", "bore: 12 kg",
        "s.yaml:12:60: string.1.bore = 12 kg (unit `kg` is not known");
    row("not positive", "length: 450 mm", "length: 0 mm",
        "s.yaml:12:29: string.1.length = 0 mm (must be greater than 0");
    row("no number", "mass_after: 0.3 kg", "mass_after: .nan",
        "string.9.mass_after = .nan (must be a finite number)");
    row("more than all", "loss: 2 %", "loss: 120 %", "string.2.loss = 120 % (must be in [0, 100) %");
    row("end of an area", "diameter: 45 mm, bore: 12 mm", "area: 1000 mm^2, end_diameter: 60 mm",
        "string.1.end_diameter (goes with a diameter, not with an area)");
    row("end area of a diameter", "bore: 12 mm", "end_area: 1200 mm^2",
        "string.1.end_area (goes with an area, not with a diameter)");
    row("two ends", "bore: 12 mm", "end_diameter: 60 mm, end_area: 1200 mm^2",
        "string.1.end_area (goes with an area, not with a diameter)");
    row("end within the bore", "bore: 12 mm", "bore: 12 mm, end_diameter: 12 mm",
        "string.1.end_diameter = 12 mm (must be larger than the bore of 12 mm)");
    row("face within the bore", "{length: 250 mm, diameter: 38 mm}",
        "{length: 250 mm, diameter: 38 mm, end_diameter: 11 mm}",
        "hammer.2.end_diameter = 11 mm (is so narrow that its face only covers the bore of 12 mm");
    row("unknown key", "bore: 12 mm", "boer: 12 mm",
        "string.1.boer (is not a known key, did you mean `bore`?)");
    row("twice", "bore: 12 mm", "length: 1 m", "s.yaml:12:54: string.1.length (is given twice)");
    row("no length", "length: 70 mm, ", "", "s.yaml:17:5: string.8.length (is missing: write for example");
    row("no diameter", "diameter: 76 mm, ", "", "string.9.diameter (is missing: give it or string.9.area)");
    row("area and diameter", "bore: 12 mm", "area: 12 cm^2",
        "string.1.area (cannot be combined with string.1.diameter");
    row("bore too wide", "bore: 12 mm", "bore: 45 mm",
        "s.yaml:12:60: string.1.bore = 45 mm (must be less than the diameter of 45 mm)");
    row("a place as a name", "name: adapter", "name: 7",
        "s.yaml:12:12: string.1.name = 7 (must not be a whole number");
    row("repeat of nothing", "repeat: 3", "repeat: 0",
        "s.yaml:13:13: string.2.repeat = 0 (must be in [1, 1000])");
    row("repeat of a part", "repeat: 3", "repeat: 2.5", "string.2.repeat = 2.5 (must be a whole number)");
    row("repeat of a word", "repeat: 3", "repeat: thrice", "string.2.repeat = thrice (is not a number)");
    row("repeat missing", "repeat: 3\n    of:", "of:", "s.yaml:13:5: string.2.repeat (is missing");
    row("repeat in a repeat", "{name: rod, length: 3660 mm", "{repeat: 2, length: 3660 mm",
        "s.yaml:16:9: string.3 (a repeat cannot contain another one)");
    row("no section", "{length: 250 mm, diameter: 38 mm}", "38 mm",
        "s.yaml:8:7: hammer.2 (must be a section");
    row("no truth", "restrike: true ", "restrike: often ",
        "s.yaml:10:13: hammer.restrike = often (must be true or false)");
    row("no velocity", "velocity: 10 m/s", "velocity: 0 m/s",
        "s.yaml:5:13: hammer.velocity = 0 m/s (must be greater than 0)");
    row("rod", "bit_rock:", "rod: {}\nbit_rock:", "s.yaml:19:1: rod (belongs to a uniform rod");
    row("pulse", "bit_rock:", "pulse: {}\nbit_rock:", "s.yaml:19:1: pulse (cannot be combined with `hammer`");
    row("neither hammer nor pulse", "hammer:\n", "hamer:\n",
        "hamer (is not a known key, did you mean `hammer`?)");
    row("format 1", "drillwave: 2", "drillwave: 1",
        "s.yaml:4:1: hammer (belongs to a drill string: a file that has it begins with `drillwave: 2`)");
    row("newer", "drillwave: 2", "drillwave: 3",
        "s.yaml:1:12: drillwave = 3 (this file says drillwave: 3; this program reads up to 2");
    row("no format", "drillwave: 2\n", "", "drillwave (is missing: the first line must be `drillwave: 2`)");
    row("no rock", "bit_rock:", "bit_rok:", "bit_rok (is not a known key, did you mean `bit_rock`?)");
    row("end of time",
        "bit_rock:", "end_time: 0 ms\nbit_rock:", "s.yaml:19:11: end_time = 0 ms (must be greater than 0)");
    row("no diameter", "diameter: 50 mm", "diameter: 1e-170 mm",
        "s.yaml:7:34: hammer.1.diameter = 1e-170 mm (must be in [1e-06, 1000] m)");
    row("no length", "length: 450 mm", "length: 1e-300 m",
        "string.1.length = 1e-300 m (must be in [1e-06, 1e+05] m)");
    row("no area", "diameter: 45 mm, bore: 12 mm", "area: 1e-300 m^2",
        "string.1.area = 1e-300 m^2 (must be in [1e-12, 1e+06] m^2)");
    row("more than any mass", "mass_after: 0.3 kg", "mass_after: 1e300 kg",
        "string.9.mass_after = 1e300 kg (must be in");
    row("more than any decay", "attenuation: 0.002 1/m", "attenuation: 1e308 1/m", "string.3.attenuation");
    row("a face as of air", "face_stiffness: 10 GN/m", "face_stiffness: 1e-300 N/m",
        "hammer.face_stiffness = 1e-300 N/m (must be in [1, 1e+18] N/m)");
    row("a face beyond all", "face_stiffness: 10 GN/m", "face_stiffness: 1e300 N/m", "hammer.face_stiffness");
    row("a rock as of air", "stiffness: 100 MN/m", "stiffness: 1e-308 N/m",
        "bit_rock.stiffness = 1e-314 MN/m (must be in");
    row("a rock beyond all", "stiffness: 100 MN/m", "stiffness: 1e308 N/m",
        "bit_rock.stiffness = 1e302 MN/m");
    row("an empty name", "name: adapter", "name: \"\"",
        "string.1.name =  (is empty; leave it out for a section without a name");
    row("a name without a letter", "name: adapter", "name: \"…\"", "string.1.name = … (must have a letter)");
    row("a name that turns the line", "name: adapter", "name: \"rod\u202E\"",
        "string.1.name = rod\\u202E (must have no characters that change the reading direction)");
}

void TestStringFile::wrongFilesAreRefusedWhereTheyAreWrong() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, problem);
    const QStringList problems = problemsOf(replaced(manualFile, from.toStdString(), to.toStdString()));
    QVERIFY2(problems.join('\n').contains(problem), qPrintable(problems.join('\n')));
}

void TestStringFile::everyProblemOfAFileIsToldAtOnce() {
    std::string text = replaced(manualFile, "velocity: 10 m/s", "velocty: 10 m/s");
    text = replaced(text, "length: 450 mm", "length: -1 mm");
    text = replaced(text, "loss: 2 %", "loss: 2 mm");
    text = replaced(text, "gamma: 0.1", "gamma: 7");
    QCOMPARE(problemsOf(text).size(), 4);
    QVERIFY(problemsOf("drillwave: 2\nhammer: {velocity: 3 m/s, sections: []}\nstring: []\n"
                       "bit_rock: {stiffness: 1 MN/m, gamma: 1}\n")
                .join('\n')
                .contains("string (must have at least one section)"));
}

void TestStringFile::aForceStandsInPlaceOfTheHammer() {
    const auto fileWith = [](const std::string& pulse) {
        return "drillwave: 2\npulse: " + pulse +
               "\nstring:\n- {name: rod, length: 3 m, diameter: 38 mm}\n- {length: 0.1 m, diameter: 60 mm}\n"
               "bit_rock: {stiffness: 100 MN/m, gamma: 0.1}\n";
    };
    const Scenario scenario =
        parsed(fileWith("{shape: half_sine, duration: 200 us, impulse: 51 N s}")).scenario;
    QVERIFY(isString(scenario) && isForced(scenario));
    QCOMPARE(scenario.pulse.shape, PulseShape::halfSine);
    QVERIFY(std::abs(scalesOf(scenario).force - 255e3) < 1e-6);
    QVERIFY(scenario == parsed(scenarioText(scenario)).scenario);

    const Scenario piston =
        parsed(fileWith("{shape: piston, length: 0.5 m, diameter: 50 mm, velocity: 9 m/s}")).scenario;
    QVERIFY(std::abs(pistonImpedanceRatio(piston) - 50.0 * 50 / 38 / 38) < 1e-12);
    QVERIFY(piston == parsed(scenarioText(piston)).scenario);

    const Scenario table =
        parsed(fileWith("{shape: table, points: [[0 us, 0 kN], [50 us, 300 kN], [200 us, 0 kN]]}")).scenario;
    QVERIFY(std::abs(pulseImpulse(table) - 30) < 1e-12);
    QVERIFY(table == parsed(scenarioText(table)).scenario);

    // One number is patched in its place; another drive is another file.
    ScenarioDocument document =
        parsed(fileWith("{shape: half_sine, duration: 200 us, force: 255 kN}  # measured"));
    findParameter("pulse.duration")->assign(document.scenario, 300e-6);
    const std::string text = writeScenario(document);
    QVERIFY(text.find("duration: 300 us") != std::string::npos &&
            text.find("# measured") != std::string::npos);
    QVERIFY(parsed(text).scenario == document.scenario);
    document.scenario.drillString.hammer = parsed(manualFile).scenario.drillString.hammer;
    document.scenario.pulse = Pulse();
    QVERIFY(parsed(writeScenario(document)).scenario == document.scenario);
}

void TestStringFile::aForceIsRefusedWhereItIsNone() {
    const auto problems = [](const std::string& drive) {
        return problemsOf(
                   "drillwave: 2\n" + drive +
                   "string: [{length: 3 m, diameter: 38 mm}]\nbit_rock: {stiffness: 1 MN/m, gamma: 1}\n")
            .join('\n');
    };
    QVERIFY(problems("pulse: {shape: rigid_body, duration: 1 ms, impulse: 1 N s}\n")
                .contains("pulse.shape = rigid_body (is the reference case of a uniform rod"));
    QVERIFY(problems("").contains("hammer (is missing"));
    QVERIFY(problems("hammer: {velocity: 3 m/s, sections: []}\n").contains("must have at least one section"));
    QVERIFY(
        problems("pulse: {shape: half_sine, duration: 1, impulse: 1 N s}\n").contains("pulse.duration = 1"));
}

void TestStringFile::repeatsAreCountedBeforeTheyAreWrittenOut() {
    const QStringList huge = problemsOf(replaced(manualFile, "repeat: 3", "repeat: 1000000000"));
    QCOMPARE(huge.size(), 1);
    QVERIFY(huge.first().contains("must be in [1, 1000]"));
    const QStringList many = problemsOf(replaced(manualFile, "repeat: 3", "repeat: 500"));
    QCOMPARE(many, QStringList("s.yaml:11:1: string (has more than 1000 sections, its repeats written out)"));
}

void TestStringFile::aThousandSectionsAreAllowed() {
    const auto file = [](int count) {
        std::string text =
            "drillwave: 2\nhammer: {velocity: 9 m/s, sections: [{length: 1 m, area: 20 cm^2}]}\nstring:\n";
        for (int i = 0; i < count; ++i) text += "- {length: 10 mm, area: 20 cm^2}\n";
        return text + "bit_rock: {stiffness: 1 GN/m, gamma: 1}\n";
    };
    QCOMPARE(sectionCount(parsed(file(1000)).scenario.drillString), std::uint64_t(1000));
    QCOMPARE(problemsOf(file(1001)).size(), 1);
    QCOMPARE(problemsOf(file(20000)).size(), 1);
}

void TestStringFile::anUnchangedFileIsSavedByteForByte() {
    for (const char* text : {manualFile, blockFile}) compareText(writeScenario(parsed(text)), text);
}

void TestStringFile::aChangedValueIsPatchedInItsPlace() {
    ScenarioDocument document = parsed(manualFile);
    DrillString& drillString = document.scenario.drillString;
    drillString.hammer.velocity = 9;
    drillString.hammer.restrike = false;
    drillString.parts[1].repeat = 5;
    drillString.parts[1].sections[1].length = 3.05;
    drillString.parts[1].sections[0].loss = 0;
    drillString.parts[3].sections[0].massAfter = 0.5;
    drillString.endTime = 0.012;
    std::string expected = replaced(manualFile, "10 m/s", "9 m/s");
    expected = replaced(expected,
                        "restrike: true                             # false: the hammer is withdrawn "
                        "after the first separation",
                        "restrike: false");
    expected = replaced(expected, "repeat: 3", "repeat: 5");
    expected = replaced(expected, "3660 mm", "3050 mm");
    expected = replaced(expected, "loss: 2 %", "loss: 0 %");
    expected = replaced(expected, "0.3 kg", "0.5 kg");
    expected = replaced(expected, "rods\n", "rods\nend_time: 12 ms\n");
    compareText(writeScenario(document), expected);

    document = parsed(blockFile);
    document.scenario.drillString.hammer.sections[0].length = 0.254;
    document.scenario.drillString.parts[0].sections[0].bore = 0.01;
    document.scenario.drillString.parts[0].sections[0].diameter = 0.0508;
    document.scenario.drillString.parts[1].sections[0].loss = 0.05;
    expected = replaced(blockFile, "12 in     # rear", "10 in");
    expected = replaced(expected, "1.5 in\n", "2 in\n  bore: 10 mm\n");
    expected = replaced(expected, "0.03", "0.05");
    compareText(writeScenario(document), expected);
}

void TestStringFile::aPartThatWentTakesOnlyItsLines() {
    ScenarioDocument document = parsed(blockFile);
    document.scenario.drillString.parts.pop_back();
    std::string expected(blockFile);
    const std::size_t part = expected.rfind("- repeat:");
    compareText(writeScenario(document), expected.erase(part, expected.find("bit_rock:") - part));
}

void TestStringFile::aNewStringIsWrittenInItsCustomaryForm() {
    compareText(writeScenario({parsed(manualFile).scenario, "", ""}), R"(drillwave: 2
title: T38, three rods
material: {youngs_modulus: 210 GPa, density: 7850 kg/m^3}
hammer:
  velocity: 10 m/s
  face_stiffness: 10 GN/m
  sections:
    - {length: 300 mm, diameter: 50 mm}
    - {length: 250 mm, diameter: 38 mm}
string:
  - {name: adapter, length: 450 mm, diameter: 45 mm, bore: 12 mm}
  - repeat: 3
    of:
      - {name: coupling, length: 190 mm, diameter: 56 mm, bore: 14.5 mm, loss: 2 %}
      - {name: rod, length: 3660 mm, diameter: 39 mm, bore: 14.5 mm, attenuation: 0.002 1/m, yield_strength: 900 MPa}
  - {name: bit skirt, length: 70 mm, diameter: 56 mm, bore: 14.5 mm}
  - {name: bit head, length: 60 mm, diameter: 76 mm, mass_after: 0.3 kg}
bit_rock:
  stiffness: 100 MN/m
  gamma: 0.1
  gap: 0 mm
drill:
  blow_frequency: 60 Hz
  thrust: 8 kN
)");
}

void TestStringFile::theNameOfAPresetIsKept() {
    ScenarioDocument document = parsed(manualFile);
    Section& adapter = document.scenario.drillString.parts[0].sections[0];
    adapter.preset = "T38 shank, 450 mm";
    const std::string patched = writeScenario(document);
    QCOMPARE(patched,
             replaced(manualFile, "- {name: adapter,", "- {name: adapter, preset: \"T38 shank, 450 mm\","));
    QVERIFY(parsed(patched).scenario == document.scenario);
    QVERIFY(parsed(writeScenario({document.scenario, "", ""})).scenario ==
            withoutUnusedValues(document.scenario));
    // A changed number is no longer that of the preset.
    Scenario changed = document.scenario;
    const KeptParameter length = findParameter("string.adapter.length");
    length->assign(changed, *length->value(changed));
    QCOMPARE(changed.drillString.parts[0].sections[0].preset, std::string("T38 shank, 450 mm"));
    length->assign(changed, 0.4);
    QVERIFY(changed.drillString.parts[0].sections[0].preset.empty());
    QCOMPARE(writeScenario({changed, patched, ""}).find("preset"), std::string::npos);
}

void TestStringFile::everyNewStringReadsBackTheSame() {
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        const Scenario scenario = randomString(random);
        const std::vector<InputProblem> problems = validate(scenario);
        QVERIFY2(problems.empty(), problems.empty() ? "" : problems.front().text.text().c_str());
        const std::string text = writeScenario({scenario, "", ""});
        QVERIFY2(parsed(text).scenario == withoutUnusedValues(scenario), text.c_str());
    }
}

void TestStringFile::randomEditsReadBackTheSame() {
    Random random(12);
    int patched = 0;
    for (int i = 0; i < 400; ++i) {
        ScenarioDocument document = parsed(i % 2 == 0 ? manualFile : blockFile);
        Section& section = document.scenario.drillString.parts[random() % 2].sections[0];
        const SectionField& field = sectionFields()[random() % sectionFields().size()];
        if (field.clear && random() % 2 == 0)
            field.clear(section);
        else if (field.applies(section))
            field.assign(section, between(field.plausible, random));
        if (i % 7 == 0) section.name = "probe";
        if (i % 3 == 0) document.scenario.drillString.hammer.restrike = i % 2 == 0;
        for (const Parameter& parameter : parameters()) {
            if (!parameter.applies(document.scenario) || parameter.isGroup() || random() % 8 != 0) continue;
            parameter.assign(document.scenario, plausibleValue(parameter, random));
            if (parameter.rules.clear && random() % 2 == 0) parameter.rules.clear(document.scenario);
        }
        if (i % 11 == 0) document.scenario.drill = {};
        if (!validate(document.scenario).empty()) continue;
        const std::string text = writeScenario(document);
        const ScenarioDocument saved = parsed(text);
        QVERIFY2(saved.scenario == withoutUnusedValues(document.scenario), text.c_str());
        compareText(writeScenario(saved), text);
        patched += text.find(i % 2 == 0 ? "from the shank" : "the only one") != std::string::npos;
    }
    QVERIFY2(patched > 250, qPrintable(QString::number(patched)));
}

QTEST_APPLESS_MAIN(TestStringFile)
#include "tst_string_file.moc"
