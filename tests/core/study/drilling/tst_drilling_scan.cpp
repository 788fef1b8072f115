// SPDX-License-Identifier: GPL-3.0-or-later
// A scan takes no work that its answer does not need, and the answer does not depend on that (drilling §7).
#include <QtTest>

#include <cmath>

#include "core/study/scan/drilling_scan.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario exampleWithDashpot() {
    Scenario scenario = parseScenario(findExample("t38_medium_rock")->text, "").scenario;
    scenario.drill.blowFrequency = 60;
    scenario.drill.waveLoss = 0.1;
    scenario.drill.machineMass = 200;
    scenario.drill.damperDamping = 6300;
    return scenario;
}

DrillingScan scanOver(const std::string& axis, const Scenario& scenario) {
    const DrillingSettings settings{.blows = 200, .settle = 60, .cells = scanCells};
    return scanDrilling(scenario, parseAxis(axis).axis, settings, {});
}

}  // namespace

class TestDrillingScan : public QObject {
    Q_OBJECT

  private slots:
    void whatIsTheSameIsNotMarchedTwice();
    void theFullRateOfAThrustIsThatOfEach();
};

/// From 5 kN on the bit rests or repeats, from wherever it begins; at 3.2 kN it does neither.
void TestDrillingScan::whatIsTheSameIsNotMarchedTwice() {
    const DrillingScan regular = scanOver("drill.thrust=5kN,6.5kN,8kN", exampleWithDashpot());
    QCOMPARE(regular.points.size(), 3UL);
    QVERIFY2(regular.bouncingBlows < 3 * 200 * 2 / 3, qPrintable(QString::number(regular.bouncingBlows)));
    const DrillingScan irregular = scanOver("drill.thrust=3.2kN,3.3kN", exampleWithDashpot());
    QCOMPARE(irregular.bouncingBlows, 2 * 200L);
}

void TestDrillingScan::theFullRateOfAThrustIsThatOfEach() {
    const Scenario scenario = exampleWithDashpot();
    const DrillingScan scan = scanOver("drill.thrust=3.4kN,6kN", scenario);
    for (const DrillingScanPoint& point : scan.points) {
        if (point.start != DrillingStart::rest) continue;
        Scenario alone = scenario;
        alone.drill.thrust = point.value;
        const DrillingResult result =
            studyDrilling(alone, scan.settings, {.cellError = false, .lyapunov = false});
        QVERIFY(result.fullRateShare && point.result.fullRateShare);
        QCOMPARE(*point.result.fullRateShare, *result.fullRateShare);
        QCOMPARE(point.result.verdict, result.verdict);
    }
}

QTEST_GUILESS_MAIN(TestDrillingScan)
#include "tst_drilling_scan.moc"
