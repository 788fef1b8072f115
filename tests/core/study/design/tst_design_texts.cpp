// SPDX-License-Identifier: GPL-3.0-or-later
// Choices of a design study by the names of presets.
#include <QTest>

#include "core/model/validation.h"
#include "core/report/design_words.h"
#include "core/study/design/design_check.h"
#include "core/study/design/design_texts.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario example(const char* name) {
    return parseScenario(findExample(name)->text, name).scenario;
}

ParsedAxis choice(std::string_view text, const char* of = "t38_medium_rock") {
    return parseChoice(text, example(of), builtInLookup());
}

std::vector<std::string> namesOf(const ParsedAxis& parsed) {
    std::vector<std::string> names;
    for (std::uint64_t i = 0; i < parsed.axis.count; ++i)
        parsed.axis.column().appendText(names.emplace_back(), parsed.axis.value(i));
    return names;
}

DesignStudy studyOf(const char* of, const std::vector<std::string>& choices) {
    DesignStudy study;
    study.base = example(of);
    study.uncertain = {parseUncertain("bit_rock.gap=0mm:1mm").input};
    for (const std::string& text : choices) study.choices.push_back(choice(text, of).axis);
    study.aims = customaryAims(study.base);
    study.samples = leastDesignSamples;
    return study;
}

const Preset& presetNamed(std::string_view name) {
    for (const Preset& preset : builtInPresets())
        if (preset.name == name) return preset;
    qFatal("no such preset");
}

}  // namespace

class TestDesignTexts : public QObject {
    Q_OBJECT

  private slots:
    void namesMayHaveCommasAndBeCutShort();
    void presetsThatDoNotFitAreRefused_data();
    void presetsThatDoNotFitAreRefused();
    void designsAreTheScenarioWithThePreset();
    void pistonsAndBitsReplaceSectionsOfAString();
    void theScenarioWithOneOfThePresetsIsThePresentDesign();
    void presetsExcludeWhatTheySet_data();
    void presetsExcludeWhatTheySet();
    void percentAboutAChosenHammerIsTaken();
    void equalChoicesAreEqual();
    void numbersAreReadAsBefore();
};

void TestDesignTexts::namesMayHaveCommasAndBeCutShort() {
    const ParsedAxis hammers =
        choice("hammer=medium drifter, piston,light,HEAVY drifter, piston,medium drifter");
    QVERIFY2(hammers.problem.isEmpty(), hammers.problem.text().c_str());
    QCOMPARE(namesOf(hammers),
             (std::vector<std::string>{"medium drifter, piston", "light drifter, short blow",
                                       "heavy drifter, piston", "medium drifter"}));
    QCOMPARE(namesOf(choice("rod = T45")), std::vector<std::string>{"T45, round 46 mm"});
    QCOMPARE(hammers.axis.key(), std::string_view("hammer"));
}

void TestDesignTexts::presetsThatDoNotFitAreRefused_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("problem");
    QTest::addColumn<bool>("isValue");
    QTest::newRow("rod in a string") << "t38_string"
                                     << "rod=T38"
                                     << "rod: a preset of a rod is for uniform rods" << true;
    QTest::newRow("bit of a uniform rod") << "t38_medium_rock"
                                          << "bit=T38, 76 mm"
                                          << "bit: a uniform rod has no bit" << true;
    QTest::newRow("hammer of groups") << "paper_fig4b"
                                      << "hammer=medium drifter"
                                      << "hammer: presets need physical units" << true;
    QTest::newRow("force in a string") << "t38_string"
                                       << "hammer=medium drifter"
                                       << "hammer medium drifter: does not fit a drill string" << true;
    QTest::newRow("rod for a hammer") << "t38_medium_rock"
                                      << "hammer=T38, round 38 mm"
                                      << "hammer T38, round 38 mm: does not fit a uniform rod" << true;
    QTest::newRow("mistyped") << "t38_medium_rock"
                              << "hammer=mediun drifter"
                              << "did you mean `medium drifter`?" << false;
    QTest::newRow("several begin so") << "t38_medium_rock"
                                      << "hammer=Epiroc"
                                      << "may be `Epiroc COP 628`, `Epiroc COP 1028`" << false;
    QTest::newRow("none") << "t38_medium_rock"
                          << "hammer="
                          << "`drillwave presets` lists them" << false;
}

void TestDesignTexts::presetsThatDoNotFitAreRefused() {
    QFETCH(QString, example);
    QFETCH(QString, text);
    QFETCH(QString, problem);
    QFETCH(bool, isValue);
    const ParsedAxis parsed = choice(text.toStdString(), example.toUtf8().constData());
    QVERIFY2(QString::fromStdString(parsed.problem.text()).contains(problem), parsed.problem.text().c_str());
    QCOMPARE(parsed.kind == ParsedAxis::Kind::badValue, isValue);
}

void TestDesignTexts::designsAreTheScenarioWithThePreset() {
    const DesignStudy study = studyOf("t38_medium_rock", {"hammer=medium drifter, piston,light,heavy",
                                                          "rod=T38, round 39 mm,T45", "rod.length=3m,4m"});
    QVERIFY(problemsOf(study).empty());
    QCOMPARE(study.designCount(), std::uint64_t{12});
    Scenario expected = withPreset(study.base, presetNamed("light drifter, short blow"));
    expected = withPreset(expected, presetNamed("T45, round 46 mm"));
    expected.rod.length = 4;
    QVERIFY(designScenario(study, 7) == expected);
    QCOMPARE(designName(study, 7), std::string("light drifter, short blow, T45, round 46 mm, 4 m"));
    // whatever was set before: a piston leaves nothing behind
    AxisScenario scene(study.base, study.choices);
    scene.set(study.choice(3));
    QVERIFY(scene.set(study.choice(7)) == expected);
}

void TestDesignTexts::pistonsAndBitsReplaceSectionsOfAString() {
    const DesignStudy study =
        studyOf("t38_string", {"hammer=T38 drifter,Epiroc COP 1838", "bit=T38, 76 mm,R32, 48 mm"});
    QVERIFY(problemsOf(study).empty());
    const Scenario design = designScenario(study, 3);
    const SectionPreset *piston = nullptr, *bit = nullptr;
    for (const SectionPreset& preset : builtInSectionPresets()) {
        if (preset.name == "Epiroc COP 1838") piston = &preset;
        if (preset.kind == SectionPresetKind::bit && preset.name == "R32, 48 mm") bit = &preset;
    }
    QVERIFY(piston && bit);
    QVERIFY(design.drillString.hammer.sections == piston->sections);
    const auto& parts = design.drillString.parts;
    const auto& before = study.base.drillString.parts;
    QCOMPARE(parts.size(), before.size());  // both bits have a skirt and a head
    for (std::size_t i = 0; i < bit->sections.size(); ++i)
        QVERIFY(parts[parts.size() - bit->sections.size() + i].sections.front() == bit->sections[i]);
    for (std::size_t i = 0; i + bit->sections.size() < parts.size(); ++i)
        QVERIFY(parts[i].sections == before[i].sections);
    QVERIFY(validate(design).empty());
}

void TestDesignTexts::theScenarioWithOneOfThePresetsIsThePresentDesign() {
    DesignStudy study = studyOf("t38_medium_rock", {"hammer=light,medium drifter"});
    study.base = withPreset(study.base, presetNamed("medium drifter"));
    QCOMPARE(presentDesign(study), std::optional<std::size_t>(1));
    study.base.pulse.duration *= 1.1;
    QVERIFY(!presentDesign(study));
}

void TestDesignTexts::presetsExcludeWhatTheySet_data() {
    QTest::addColumn<QString>("choice");
    QTest::addColumn<QString>("uncertain");
    QTest::addColumn<bool>("keepsEnergy");
    QTest::addColumn<QString>("problem");
    QTest::newRow("chosen twice") << "pulse.duration=100us,200us"
                                  << "bit_rock.gap=0mm:1mm" << false
                                  << "hammer and pulse.duration set the same thing; leave out one of them";
    QTest::newRow("two hammers") << "hammer=heavy"
                                 << "bit_rock.gap=0mm:1mm" << false << "hammer is given twice; give it once";
    QTest::newRow("chosen and uncertain")
        << "rod.length=3m,4m"
        << "pulse.duration=100us:200us" << false
        << "pulse.duration is both design variable and uncertain: only +-P% about its value can be both";
    QTest::newRow("energy kept")
        << "rod.length=3m,4m"
        << "bit_rock.gap=0mm:1mm" << true
        << "keeping the energy sets pulse.impulse, and so does the choice of hammer; "
           "leave out that choice, or do not keep the energy (--no-keep-energy)";
}

void TestDesignTexts::presetsExcludeWhatTheySet() {
    QFETCH(QString, choice);
    QFETCH(QString, uncertain);
    QFETCH(bool, keepsEnergy);
    QFETCH(QString, problem);
    DesignStudy study = studyOf("t38_medium_rock", {"hammer=light,medium drifter", choice.toStdString()});
    study.uncertain = {parseUncertain(uncertain.toStdString()).input};
    study.keepsEnergy = keepsEnergy;
    const std::vector<DesignProblemLine> lines = problemsOf(study);
    QVERIFY(!lines.empty());
    QCOMPARE(QString::fromStdString(lines.front().text.text()), problem);
    QVERIFY(!lines.front().isUsage);
}

void TestDesignTexts::percentAboutAChosenHammerIsTaken() {
    DesignStudy study = studyOf("t38_medium_rock", {"hammer=light,medium drifter"});
    study.uncertain.push_back(parseUncertain("pulse.duration=+-10%").input);
    QVERIFY(problemsOf(study).empty());
    QVERIFY(runDesign(study, {.jobs = 1}).best.robust);
}

void TestDesignTexts::equalChoicesAreEqual() {
    QVERIFY(choice("hammer=light,heavy").axis == choice("hammer=light drifter, short blow,heavy").axis);
    QVERIFY(choice("hammer=light,heavy").axis != choice("hammer=heavy,light").axis);
    QVERIFY(choice("hammer=light").axis != choice("rod=T45").axis);
}

void TestDesignTexts::numbersAreReadAsBefore() {
    QVERIFY(choice("rod.length=3m:4m:3").axis == parseAxis("rod.length=3m:4m:3").axis);
    QVERIFY(!choosesPresets("hammer.velocity=8m/s,9m/s") && choosesPresets(" bit =T38"));
}

QTEST_GUILESS_MAIN(TestDesignTexts)
#include "tst_design_texts.moc"
