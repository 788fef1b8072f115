// SPDX-License-Identifier: GPL-3.0-or-later
// A scan takes no work that its answer does not need, and the answer does not depend on that (drilling §7).
#include <QTest>

#include <cmath>
#include <set>

#include "core/report/drilling_scan_report.h"
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
    void theSentenceNamesTheWindows();
    void aValueThatNoScenarioHasIsRefused();
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

void TestDrillingScan::theSentenceNamesTheWindows() {
    // What holds is made up: where it does in a real scan hangs on the last digits of a motion.
    DrillingScan scan = scanOver("drill.thrust=3kN,4kN,5kN,6kN,7kN", exampleWithDashpot());
    const auto sentenceOf = [&](const std::set<double>& full) {
        for (DrillingScanPoint& point : scan.points) {
            point.result.verdict =
                full.contains(point.value / 1000) ? DrillingVerdict::fullRate : DrillingVerdict::rateLost;
            if (!point.result.statistics) point.result.statistics.emplace();
        }
        const std::string all = scanSentence(scan).text();
        return all.substr(0, all.find(';'));
    };
    const std::string begin = "It drills at full rate ";
    QCOMPARE(sentenceOf({}), begin + "at none of the values");
    QCOMPARE(sentenceOf({3, 4, 5, 6, 7}), begin + "at all values");
    QCOMPARE(sentenceOf({5, 6, 7}), begin + "from 5 kN on");
    QCOMPARE(sentenceOf({3, 4}), begin + "up to 4 kN");
    QCOMPARE(sentenceOf({4}), begin + "at 4 kN");
    QCOMPARE(sentenceOf({3, 5, 6}), begin + "up to 3 kN and from 5 kN to 6 kN");
    QCOMPARE(sentenceOf({3, 5, 7}), begin + "up to 3 kN, at 5 kN and from 7 kN on");
}

/// Before anything is marched, and with the number that does not fit.
void TestDrillingScan::aValueThatNoScenarioHasIsRefused() {
    const std::vector<Message> refusals =
        scanRefusals(exampleWithDashpot(), parseAxis("rod.bore=5mm,50mm").axis, {});
    QCOMPARE(refusals.size(), std::size_t{1});
    QVERIFY2(refusals.front().text().starts_with("rod.bore = "), refusals.front().text().c_str());
}

QTEST_GUILESS_MAIN(TestDrillingScan)
#include "tst_drilling_scan.moc"
