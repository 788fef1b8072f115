// SPDX-License-Identifier: GPL-3.0-or-later
// The block `design` of scenario files of both formats: read, saved, patched in place.
#include <QTest>

#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario_texts.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const std::string block =
    "design:\n"
    "  uncertain:\n"
    "    - bit_rock.stiffness=50MN/m:250MN/m:log\n"
    "    - bit_rock.gap=+-10%\n"
    "  choose:\n"
    "    - hammer=medium drifter,light drifter, short blow\n"
    "  aims:\n"
    "    - max:efficiency@q05\n"
    "  at_most:\n"
    "    - thrust@q95=8kN\n"
    "  at_least:\n"
    "    - efficiency@mean=0.5\n"
    "  keep_energy: true\n"
    "  samples: 256\n"
    "  seed: 0\n";

DesignSetup setupOfBlock() {
    return {.uncertain = {"bit_rock.stiffness=50MN/m:250MN/m:log", "bit_rock.gap=+-10%"},
            .choose = {"hammer=medium drifter,light drifter, short blow"},
            .aims = {"max:efficiency@q05"},
            .atMost = {"thrust@q95=8kN"},
            .atLeast = {"efficiency@mean=0.5"},
            .keepEnergy = true,
            .samples = 256,
            .seed = 0};
}

std::string exampleText(const char* name) {
    return std::string(findExample(name)->text);
}

}  // namespace

class TestDesignBlock : public QObject {
    Q_OBJECT

  private slots:
    void bothFormatsHaveIt();
    void aSetUpIsAppendedAndTakenOutAgain();
    void aChangedSetUpIsExchangedInItsPlace();
    void aFileWrittenAnewHasItLast();
    void whatIsNoSetUpIsRefused_data();
    void whatIsNoSetUpIsRefused();
};

void TestDesignBlock::bothFormatsHaveIt() {
    for (const char* name : {"t38_medium_rock", "t38_string", "paper_fig4b"}) {
        const std::string text = exampleText(name);
        const ScenarioDocument with = parsed(text + block);
        QVERIFY(with.design == setupOfBlock());
        QVERIFY(with.scenario == parsed(text).scenario);
        compareText(writeScenario(with), text + block);
        QVERIFY(parsed(text).design.isEmpty());
    }
}

void TestDesignBlock::aSetUpIsAppendedAndTakenOutAgain() {
    for (const char* name : {"t38_medium_rock", "t38_string", "paper_fig4b"}) {
        const std::string text = exampleText(name);
        ScenarioDocument document = parsed(text);
        document.design = setupOfBlock();
        const std::string with = writeScenario(document);
        compareText(with, text + block);
        document = parsed(with);
        document.design = {};
        compareText(writeScenario(document), text);
    }
}

// Neither what stands around it moves, nor do comments behind other values.
void TestDesignBlock::aChangedSetUpIsExchangedInItsPlace() {
    std::string text = exampleText("t38_medium_rock");
    const std::size_t at = text.find("bit_rock:");
    text.insert(at, "design:\n  choose:\n    - rod.length=3m,4m   # two rods\n");
    ScenarioDocument document = parsed(text);
    document.design.choose = {"rod.length=3m,5m"};
    document.scenario.bitRock.gap = 1e-3;
    std::string expected = exampleText("t38_medium_rock");
    expected.insert(at, "design:\n  choose:\n    - rod.length=3m,5m\n");
    expected.replace(expected.find("gap: 0 mm"), 9, "gap: 1 mm");
    const std::string written = writeScenario(document);
    QVERIFY(parsed(written).design == document.design);
    compareText(written, expected);
}

void TestDesignBlock::aFileWrittenAnewHasItLast() {
    ScenarioDocument document{.scenario = parsed(exampleText("t38_string")).scenario,
                              .text = {},
                              .source = {},
                              .design = setupOfBlock()};
    const std::string text = writeScenario(document);
    QVERIFY(text.ends_with(block));
    QVERIFY(parsed(text).design == document.design);
}

void TestDesignBlock::whatIsNoSetUpIsRefused_data() {
    QTest::addColumn<QString>("lines");
    QTest::addColumn<QString>("problem");
    QTest::newRow("no map") << "design: yes\n"
                            << "design (must be a section";
    QTest::newRow("unknown key") << "design:\n  aim: [max:cor@mean]\n"
                                 << "did you mean `aims`?";
    QTest::newRow("no list") << "design:\n  aims: max:cor@mean\n"
                             << "design.aims (must be a list of texts";
    QTest::newRow("list in a list") << "design:\n  aims: [[a]]\n"
                                    << "design.aims (has an item that is not text";
    QTest::newRow("no truth") << "design:\n  keep_energy: 1\n"
                              << "must be true or false";
    QTest::newRow("no sample") << "design:\n  samples: 0\n"
                               << "must be a whole number from 1 to 1048576";
    QTest::newRow("seed below 0") << "design:\n  seed: -1\n"
                                  << "must be a whole number from 0 to";
}

void TestDesignBlock::whatIsNoSetUpIsRefused() {
    QFETCH(QString, lines);
    QFETCH(QString, problem);
    try {
        parseScenario(exampleText("t38_medium_rock") + lines.toStdString(), "a.yaml");
        QFAIL("is taken");
    } catch (const ScenarioError& error) {
        QCOMPARE(error.lines().size(), std::size_t{1});
        QVERIFY2(QString::fromStdString(error.lines().front()).contains(problem),
                 error.lines().front().c_str());
    }
}

QTEST_GUILESS_MAIN(TestDesignBlock)
#include "tst_design_block.moc"
