// SPDX-License-Identifier: GPL-3.0-or-later
// One sentence names the section that breaks first.
#include <QTest>

#include "core/blow/blow.h"
#include "core/blow/string_blow.h"
#include "core/report/blow_text.h"
#include "core/report/strength_words.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario example() {
    return parseScenario(findExample("t38_string")->text, "t38_string").scenario;
}

SectionStress stressed(double compression, double tension) {
    SectionStress stress;
    stress.compression.stress = compression;
    stress.tension.stress = tension;
    return stress;
}

/// Hammer, three rods.
Scenario threeRods() {
    Scenario scenario = example();
    Section rod;
    rod.name = "rod";
    rod.length = 3;
    rod.diameter = 0.039;
    scenario.drillString.hammer.sections.resize(1);
    scenario.drillString.parts = {{.sections = {rod}}, {.sections = {rod}}, {.sections = {rod}}};
    return scenario;
}

}  // namespace

class TestStrengthWords : public QObject {
    Q_OBJECT

  private slots:
    void theLargestShareIsNamedFirst() {
        Scenario scenario = threeRods();
        auto& parts = scenario.drillString.parts;
        for (StringPart& part : parts) part.sections.front().fatigueStrength = 400e6;
        parts[2].sections.front().yieldStrength = 900e6;
        const std::vector<SectionStress> stresses{stressed(600e6, 500e6), stressed(300e6, 100e6),
                                                  stressed(300e6, 300e6), stressed(855e6, 200e6)};
        QCOMPARE(strengthSentence(scenario, stresses, plainStyle()).text(),
                 std::string("During the blow, the most heavily loaded section (3rd rod) has a compression "
                             "of 855 MPa, which is 95 % of its yield strength of 900 MPa."));
        parts[2].sections.front().yieldStrength.reset();
        QCOMPARE(strengthSentence(scenario, stresses, plainStyle()).text(),
                 std::string("During the blow, the most heavily loaded section (2nd rod) has a tension of "
                             "300 MPa, which is 75 % of its fatigue strength of 400 MPa."));
        parts[0].sections.front().fatigueStrength.reset();
        QVERIFY(strengthSentence(scenario, stresses, plainStyle())
                    .text()
                    .ends_with(". No strength is given for 1 section of the string."));
    }

    void withoutStrengthsTheSentenceAsksForThem() {
        const std::vector<SectionStress> stresses(4, stressed(1e8, 1e8));
        QVERIFY(
            strengthSentence(threeRods(), stresses, plainStyle())
                .text()
                .starts_with("No section has a strength. Enter a strength (string.rod.fatigue_strength)"));
        QVERIFY(strengthSentence(threeRods(), {}, plainStyle()).isEmpty());
    }

    void runAndSharesAgreeWithTheStresses() {
        Scenario scenario = example();
        for (StringPart& part : scenario.drillString.parts)
            for (Section& section : part.sections) section.fatigueStrength = 400e6;
        const Blow blow = solveBlow(scenario, {}, Detail::histories);
        const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
        const auto uses = strengthUses(blow.scenario, stresses);
        const std::optional<std::size_t> most = mostUsedSection(uses);
        QVERIFY(most);
        for (const auto& use : uses) QVERIFY(!use || use->share() <= uses[*most]->share());
        const std::string sentence = strengthSentence(blow.scenario, stresses, plainStyle()).text();
        QVERIFY2(blowText(blow).find(sentence.substr(0, 40)) != std::string::npos, sentence.c_str());
    }
};

QTEST_GUILESS_MAIN(TestStrengthWords)
#include "tst_strength_words.moc"
