// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of sections that a study may vary: each once, by name where a name says it.
#include <QTest>

#include <algorithm>
#include <set>

#include "core/model/section_parameter.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario example(const char* name) {
    return parseScenario(findExample(name)->text, name).scenario;
}

std::vector<std::string> keysOf(const Scenario& scenario) {
    std::vector<std::string> keys;
    for (const KeptParameter& parameter : variableSectionParameters(scenario))
        keys.emplace_back(parameter->key);
    return keys;
}

bool has(const std::vector<std::string>& keys, std::string_view key) {
    return std::ranges::find(keys, key) != keys.end();
}

}  // namespace

class TestSectionChoice : public QObject {
    Q_OBJECT

  private slots:
    void namedSectionsHaveKeysOfTheirNames();
    void eachNumberIsThereOnceAndApplies();
    void sectionsThatDifferGoByPlace();
    void whatChangesNoResultIsLeftOut();
    void theSizeAskedForFirstIsThatOfTheCouplings();
    void aUniformRodHasNone();
};

void TestSectionChoice::namedSectionsHaveKeysOfTheirNames() {
    const auto keys = keysOf(example("t38_string"));
    for (const char* key : {"hammer.1.diameter", "hammer.2.length", "string.repeat", "string.adapter.length",
                            "string.coupling.diameter", "string.rod.bore", "string.bit_skirt.length"})
        QVERIFY2(has(keys, key), key);
    // No place of the six sections that the repeat brings.
    QVERIFY(!has(keys, "string.2.diameter"));
    QVERIFY(!has(keys, "string.4.diameter"));
}

void TestSectionChoice::eachNumberIsThereOnceAndApplies() {
    for (const char* name : {"t38_string", "t51_string", "r32_string"}) {
        const Scenario scenario = example(name);
        const auto keys = keysOf(scenario);
        QVERIFY(keys.size() > 20);
        QCOMPARE(std::set(keys.begin(), keys.end()).size(), keys.size());
        for (const KeptParameter& parameter : variableSectionParameters(scenario)) {
            QVERIFY(parameter->applies(scenario));
            QVERIFY2(parameter->value(scenario), std::string(parameter->key).c_str());
        }
    }
}

void TestSectionChoice::sectionsThatDifferGoByPlace() {
    Scenario scenario = example("t38_string");
    scenario.drillString.parts.back().sections.front().name = "adapter";  // as the first, of another size
    const auto keys = keysOf(scenario);
    QVERIFY(!has(keys, "string.adapter.length"));
    QVERIFY(has(keys, "string.1.length"));
    QVERIFY(has(keys, "string.9.length"));
    QVERIFY(!has(keys, "string.adapter.loss"));
    QVERIFY(has(keys, "string.adapter.attenuation"));                  // none in both
    scenario.drillString.parts.front().sections.front().name = "a=b";  // no word of a command
    QVERIFY(has(keysOf(scenario), "string.1.loss"));
}

void TestSectionChoice::whatChangesNoResultIsLeftOut() {
    Scenario scenario = example("t38_string");
    scenario.drillString.parts.front().sections.front().yieldStrength = 900e6;
    const auto keys = keysOf(scenario);
    QVERIFY(!has(keys, "string.adapter.yield_strength"));
    QVERIFY(!has(keys, "hammer.1.loss"));
    QVERIFY(has(keys, "string.adapter.loss"));
}

void TestSectionChoice::theSizeAskedForFirstIsThatOfTheCouplings() {
    Scenario scenario = example("t38_string");
    QCOMPARE(typicalSize(scenario)->key, std::string_view("string.coupling.diameter"));
    scenario.drillString.parts[1].sections.front().name.clear();
    QCOMPARE(typicalSize(scenario)->key, std::string_view("string.2.diameter"));
    scenario.drillString.parts.erase(scenario.drillString.parts.begin() + 1);
    QCOMPARE(typicalSize(scenario)->key, std::string_view("string.adapter.diameter"));
    scenario.drillString.parts.front().sections.front().area = 1e-3;
    QCOMPARE(typicalSize(scenario)->key, std::string_view("string.adapter.area"));
}

void TestSectionChoice::aUniformRodHasNone() {
    QVERIFY(keysOf(Scenario()).empty());
    QVERIFY(!typicalSize(Scenario()));
}

QTEST_APPLESS_MAIN(TestSectionChoice)
#include "tst_section_choice.moc"
