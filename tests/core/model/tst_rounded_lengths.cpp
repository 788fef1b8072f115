// SPDX-License-Identifier: GPL-3.0-or-later
// Rounded lengths share a step that lets waves be kept.
#include <QTest>

#include "core/blow/blow.h"
#include "core/model/string_edit.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

class TestRoundedLengths : public QObject {
    Q_OBJECT

  private slots:
    void longSectionsAreRoundedTo10Millimetres() {
        QCOMPARE(roundedLength(0.517), 0.52);
        QCOMPARE(roundedLength(3.6576), 3.66);
        QCOMPARE(roundedLength(0.19), 0.19);
        QCOMPARE(roundedLength(0.052), 0.05);
        QCOMPARE(roundedLength(0.032), 0.03);
        QCOMPARE(roundedLength(0.0123), 0.012);
        QCOMPARE(roundedLength(0.0001), 0.001);
    }

    void aStringOfOddLengthsKeepsItsWavesOnceRounded() {
        Scenario scenario = parseScenario(findExample("t38_string")->text, "t38_string").scenario;
        DrillString& drill = scenario.drillString;
        drill.hammer.sections.resize(1);
        drill.hammer.sections.front().length = 0.517;
        drill.parts.front().sections.front().preset = "T38 shank, 450 mm";
        for (StringPart& part : drill.parts)
            if (part.group) part.repeat = 5;
        const auto hasWaves = [](const Scenario& each) {
            return !solveBlow(each, {}, Detail::histories).impact.wavesDifference;
        };
        QVERIFY(!hasWaves(scenario));
        drill = withRoundedLengths(drill);
        QCOMPARE(drill.hammer.sections.front().length, 0.52);
        QCOMPARE(drill.parts.front().sections.front().preset, std::string("T38 shank, 450 mm"));
        QVERIFY(hasWaves(scenario));
    }
};

QTEST_GUILESS_MAIN(TestRoundedLengths)
#include "tst_rounded_lengths.moc"
