// SPDX-License-Identifier: GPL-3.0-or-later
// A scan takes no work that its answer does not need, and the answer does not depend on that (drilling §7).
#include <QTest>

#include <cmath>

#include "core/report/report_text.h"
#include "core/report/sequence_words.h"
#include "core/study/scan/drilling_scan.h"
#include "core/study/scan/scan_comparison.h"
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
    void identicalProblemsAreSolvedOnce();
    void theSentenceNamesTheBestAsFarAsTheErrorsTell();
    void anUncertainScanIsNotResolved();
    void sharesAreOfTheBestWhereBothAreResolved();
    void aValueThatNoScenarioHasIsRefused();
};

/// From 5 kN on the bit rests or repeats, from wherever it begins; at 3.2 kN it does neither.
void TestDrillingScan::identicalProblemsAreSolvedOnce() {
    const DrillingScan regular = scanOver("drill.thrust=5kN,6.5kN,8kN", exampleWithDashpot());
    QCOMPARE(regular.points.size(), 3UL);
    QVERIFY2(regular.bouncingBlows < 3 * 200 * 2 / 3, qPrintable(QString::number(regular.bouncingBlows)));
    const DrillingScan irregular = scanOver("drill.thrust=3.2kN,3.3kN", exampleWithDashpot());
    QCOMPARE(irregular.bouncingBlows, 2 * 200L);
}

namespace {

/// A scan whose rates and errors are made up, mm a blow: where the largest is in a real one hangs on the last
/// digits of a motion.
DrillingScan scanWith(const std::vector<std::pair<double, double>>& penetrations, double loss = 0.1) {
    DrillingScan scan = scanOver("drill.thrust=3kN,4kN,5kN,6kN,7kN", exampleWithDashpot());
    std::erase_if(scan.points, [](const auto& point) { return point.start != DrillingStart::rest; });
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        DrillingResult& result = scan.points[i].result;
        result.outcome = DrillingOutcome::done;
        if (!result.statistics) result.statistics.emplace();
        result.frequencyUsed = 60;
        result.hasLoss = loss > 0;
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        BlowSpread& spread = result.statistics->spreads[penetration];
        spread.mean = penetrations[i].first / 1e3 / result.units.length();
        spread.meanError = penetrations[i].second / 1e3 / result.units.length();
        result.cellErrors[penetration] = 0;
    }
    return scan;
}

QString saidOf(const DrillingScan& scan, const std::optional<Sequence>& present = {}) {
    return QString::fromStdString(inOneParagraph(scanSentences(scan, present)));
}

}  // namespace

void TestDrillingScan::theSentenceNamesTheBestAsFarAsTheErrorsTell() {
    const QString limits = QStringLiteral(" Friction, rotation and buckling are not modelled.");
    const DrillingScan clear = scanWith({{1.5, 0.01}, {1.8, 0.01}, {2, 0.01}, {1.9, 0.01}, {1.7, 0.01}});
    QCOMPARE(saidOf(clear),
             "The highest penetration rate of the scan, 7.2 m/min, is reached with a feed force of 5 kN." +
                 limits);
    const std::optional<Sequence> present = sequenceOf(clear.points[1].result);
    QCOMPARE(saidOf(clear, present),
             "The highest penetration rate of the scan, 7.2 m/min (+11.1 % compared with the present value), "
             "is reached with a feed force of "
             "5 kN." +
                 limits);
    // The present one is no less than the errors.
    QCOMPARE(saidOf(clear, sequenceOf(clear.points[2].result)),
             "The highest penetration rate of the scan, 7.2 m/min, is reached with a feed force of 5 kN." +
                 limits);
    QCOMPARE(saidOf(scanWith({{1.5, 0.01}, {1.99, 0.01}, {2, 0.01}, {1.99, 0.01}, {1.7, 0.01}})),
             "The highest penetration rate of the scan, 7.2 m/min, is reached with a feed force of 5 kN. All "
             "values from 4 kN to 6 kN give the same penetration rate within the errors of the computation." +
                 limits);
    QCOMPARE(
        saidOf(scanWith({{1.5, 0.01}, {2, 0.02}, {1.8, 0.01}, {1.99, 0.01}, {1.985, 0.01}})),
        "The highest penetration rate of the scan, 7.2 m/min, is reached with a feed force of 4 kN. These "
        "values give the same penetration rate within the errors of the computation: 4 kN, 6 kN to 7 kN." +
            limits);
    QCOMPARE(saidOf(scanWith({{2, 0.05}, {1.99, 0.05}, {2.01, 0.05}, {2, 0.05}, {2, 0.05}})),
             "All values of the scan give the same penetration rate, 7.24 m/min, within the errors of the "
             "computation." +
                 limits);
}

void TestDrillingScan::anUncertainScanIsNotResolved() {
    const QString said = saidOf(scanWith({{2.5, 1.8}, {1.8, 0.01}, {2, 0.01}, {1.9, 0.01}, {1.7, 0.01}}, 0));
    QVERIFY2(said.startsWith("The scan cannot decide which value is best: the penetrations have errors of +- "
                             "1.8 mm, because no wave loss is defined. Give a wave loss"),
             qPrintable(said));
    // One that is uncertain and yet certainly lower keeps nothing from being known.
    QVERIFY(saidOf(scanWith({{0.5, 0.3}, {1.8, 0.01}, {2, 0.01}, {1.9, 0.01}, {1.7, 0.01}}))
                .startsWith("The highest penetration rate of the scan, "));
}

void TestDrillingScan::sharesAreOfTheBestWhereBothAreResolved() {
    const DrillingScan scan = scanWith({{1.5, 0.01}, {1.8, 0.3}, {2, 0.01}, {1.4, 0.01}, {1.7, 0.01}});
    ScanComparison comparison = *compareScan(scan);
    QVERIFY(comparison.unresolved);  // 1.8 +- 0.3 may be more
    comparison = *compareScan(scanWith({{1.5, 0.01}, {1.5, 0.3}, {2, 0.01}, {1.4, 0.01}, {1.7, 0.01}}));
    QVERIFY(comparison.isResolved());
    QCOMPARE(comparison.best().at, 5000.0);
    QVERIFY(std::abs(*comparison.bestShare(comparison.entries[0].sequence) - 0.75) < 1e-12);
    QVERIFY(!comparison.bestShare(comparison.entries[1].sequence));
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
