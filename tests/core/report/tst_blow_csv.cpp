// SPDX-License-Identifier: GPL-3.0-or-later
// Histories and events as CSV: they say what was solved, and what with.
#include <QTest>

#include <sstream>

#include "core/blow/impact_summary.h"
#include "core/report/blow_csv.h"
#include "core/text/csv.h"
#include "core/text/units.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/field/bit_history.h"
#include "core/wave/field/wave_field.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Blow solved(const char* example) {
    return solveBlow(parseScenario(findExample(example)->text, example).scenario, {}, Detail::histories);
}

struct Columns {
    std::vector<std::string> header;
    std::vector<std::vector<double>> rows;
};

Columns columnsOf(const std::string& csv) {
    std::istringstream in(csv);
    CsvReader reader(in);
    Columns columns;
    CsvRecord record;
    reader.next(record);
    columns.header = record.cells;
    while (reader.next(record)) {
        columns.rows.emplace_back();
        for (const std::string& cell : record.cells) columns.rows.back().push_back(*parseNumber(cell));
    }
    return columns;
}

}  // namespace

class TestBlowCsv : public QObject {
    Q_OBJECT

  private slots:
    void historiesBeginAtRestAndEndWithTheRebound();
    void theForceIntegratesToTheImpulse();
    void theReferenceCaseHasItsMomentumFromTheStart();
    void theIncidentWaveIsCompressionAndNegative();
    void thePenetrationIsThatOfTheLawOfTheRock();
    void theFrontVelocityIsTheRateOfThePenetration();
    void theColumnsAreExplained();
    void siColumnsAreScaledAndNamed();
    void eventsAreListedInTheirOrder();
    void theHeaderGivesTheScenarioBack_data();
    void theHeaderGivesTheScenarioBack();
    void theHeaderNamesTheMethod();
    void aByteOrderMarkStaysOutOfTheHeader();
};

void TestBlowCsv::historiesBeginAtRestAndEndWithTheRebound() {
    const Blow blow = solved("paper_fig4b");
    const Columns csv = columnsOf(historiesCsv(blow, {}, OutputUnits::dimensionless));
    QCOMPARE(csv.header, (std::vector<std::string>{"time", "impact_force", "impulse", "momentum",
                                                   "incident_wave", "penetration", "front_velocity"}));
    // τ = 10: the first wave front arrives long after the pulse is over.
    QCOMPARE(csv.rows.front()[0], 10.0);
    QCOMPARE(csv.rows.front()[3], 1.0);
    QVERIFY(std::abs(csv.rows.back()[3] + blow.impact.cor) < 1e-12);
    QVERIFY(std::abs(csv.rows.back()[2] - blow.impact.impulse) < 1e-12);
}

void TestBlowCsv::theForceIntegratesToTheImpulse() {
    const Blow blow = solved("t38_medium_rock");
    const Columns csv = columnsOf(historiesCsv(blow, {}, OutputUnits::si));
    double impulse = 0;
    for (std::size_t i = 1; i < csv.rows.size(); ++i) {
        QVERIFY(csv.rows[i][0] >= csv.rows[i - 1][0]);
        QVERIFY(csv.rows[i][1] >= 0);
        impulse += (csv.rows[i][0] - csv.rows[i - 1][0]) * (csv.rows[i][1] + csv.rows[i - 1][1]) / 2;
    }
    // The chords follow the force to 1e-4 of its pieces.
    QVERIFY(std::abs(impulse / (blow.impact.impulse * blow.scales.impulse) - 1) < 2e-4);
}

void TestBlowCsv::theReferenceCaseHasItsMomentumFromTheStart() {
    const Blow blow = solved("reference_case");
    const Columns csv = columnsOf(historiesCsv(blow, {}, OutputUnits::dimensionless));
    QCOMPARE(csv.rows.front()[0], 0.0);
    QCOMPARE(csv.rows.front()[3], 1.0);
    QVERIFY(std::abs(csv.rows.back()[3] + blow.impact.cor) < 1e-12);
}

// Waves in the plots have tension positive; in the file the incident wave had the other sign.
void TestBlowCsv::theIncidentWaveIsCompressionAndNegative() {
    const Blow blow = solved("paper_fig4b");
    const Columns csv = columnsOf(historiesCsv(blow, {}, OutputUnits::dimensionless));
    // A rectangular blow pushes with F0: the first wave that arrives is a compression of that size.
    QCOMPARE(csv.rows.front()[4], -1.0);
    QCOMPARE(csv.rows.front()[4], WaveField(blow.impact).positiveWave(1, csv.rows.front()[0]));
}

// F = 2 beta U on the primary line, and unloads with 1/gamma of that slope. U in d0, so that the largest one
// is that of the summary.
void TestBlowCsv::thePenetrationIsThatOfTheLawOfTheRock() {
    const Blow blow = solved("paper_fig4b");
    const Groups groups = groupsOf(blow.scenario);
    const Columns csv = columnsOf(historiesCsv(blow, {}, OutputUnits::dimensionless));
    const ImpactSummary summary = summarize(blow.impact, blow.problem);
    double deepest = 0, largest = 0, wayOff = 0;
    for (const std::vector<double>& row : csv.rows) {
        largest = std::max(largest, row[1]);
        deepest = std::max(deepest, row[5]);
        if (row[1] <= 0) continue;
        const double law =
            largest / (2 * groups.beta) - groups.gamma * (largest - row[1]) / (2 * groups.beta);
        wayOff = std::max(wayOff, std::abs(row[5] - law));
        // The same from the waves, independently of the law.
        wayOff = std::max(wayOff, std::abs(row[5] - (bitDisplacement(blow.impact, row[0]) - groups.delta)));
    }
    QVERIFY2(wayOff < 1e-13, qPrintable(QString::number(wayOff)));
    QVERIFY(std::abs(deepest - summary.maxPenetration) < 1e-4 * deepest);
    // Away from the rock it is above the bottom of its hole at the end.
    QVERIFY(csv.rows.back()[5] < summary.residualPenetration);
}

void TestBlowCsv::theFrontVelocityIsTheRateOfThePenetration() {
    for (const char* example : {"t38_medium_rock", "reference_case", "paper_fig8_minimum"}) {
        const Blow blow = solved(example);
        const Columns csv = columnsOf(historiesCsv(blow, {}, OutputUnits::dimensionless));
        double way = 0;
        for (std::size_t i = 1; i < csv.rows.size(); ++i)
            way += (csv.rows[i][0] - csv.rows[i - 1][0]) * (csv.rows[i][6] + csv.rows[i - 1][6]) / 2;
        // The chords follow the force to 1e-4 of its pieces.
        const double moved = csv.rows.back()[5] - csv.rows.front()[5];
        QVERIFY2(std::abs(way - moved) < 1e-3 * std::max(1.0, std::abs(moved)),
                 qPrintable(QString("%1: %2, %3").arg(example).arg(way).arg(moved)));
    }
}

void TestBlowCsv::theColumnsAreExplained() {
    for (const OutputUnits units : {OutputUnits::dimensionless, OutputUnits::si})
        QVERIFY(historyColumns({}, {}, units).find("tension positive") != std::string::npos);
    QVERIFY(historyColumns({}, {}, OutputUnits::dimensionless).find("front_velocity d0/t0") !=
            std::string::npos);
}

void TestBlowCsv::siColumnsAreScaledAndNamed() {
    const Blow blow = solved("t38_medium_rock");
    const Columns plain = columnsOf(historiesCsv(blow, {}, OutputUnits::dimensionless));
    const Columns si = columnsOf(historiesCsv(blow, {}, OutputUnits::si));
    QCOMPARE(si.header,
             (std::vector<std::string>{"time [s]", "impact_force [N]", "impulse [N s]", "momentum [N s]",
                                       "incident_wave [N]", "penetration [m]", "front_velocity [m/s]"}));
    QCOMPARE(si.rows.size(), plain.rows.size());
    const double scales[] = {blow.scales.time,
                             blow.scales.force,
                             blow.scales.impulse,
                             blow.scales.impulse,
                             blow.scales.force,
                             blow.scales.penetration,
                             blow.scales.penetration / blow.scales.time};
    for (std::size_t r = 0; r < si.rows.size(); ++r)
        for (std::size_t c = 0; c < std::size(scales); ++c)
            QCOMPARE(si.rows[r][c], plain.rows[r][c] * scales[c]);
}

void TestBlowCsv::eventsAreListedInTheirOrder() {
    const Blow blow = solved("paper_fig4b");
    const std::string csv = eventsCsv(blow.impact, OutputUnits::dimensionless, blow.scales);
    // δ = 0, τ = 10: contact when the front arrives; the force turns where the rectangular wave ends.
    const QStringList lines = QString::fromStdString(csv).split('\n');
    QCOMPARE(lines[0], QString("kind,time"));
    QCOMPARE(lines[1], QString("contact,10"));
    QCOMPARE(lines[2], QString("unloading,11"));
    QVERIFY(lines[lines.size() - 2].startsWith("separation,"));
    QVERIFY(eventsCsv(blow.impact, OutputUnits::si, blow.scales).starts_with("kind,time [s]\n"));
}

void TestBlowCsv::theHeaderGivesTheScenarioBack_data() {
    QTest::addColumn<QString>("name");
    for (const Example& example : builtInExamples())
        QTest::newRow(example.name.c_str()) << QString::fromStdString(example.name);
}

void TestBlowCsv::theHeaderGivesTheScenarioBack() {
    QFETCH(QString, name);
    const Example& example = *findExample(name.toStdString());
    const Scenario scenario = parseScenario(example.text, example.name).scenario;
    const std::string csv = scenarioHeader(example.text) + "time,value\n1,2\n";
    QCOMPARE(parseScenario(scenarioFromHeader(csv), "again").scenario, scenario);
    // Also after an editor has turned the line ends.
    const QByteArray windows = QByteArray::fromStdString(csv).replace("\n", "\r\n");
    QCOMPARE(parseScenario(scenarioFromHeader(windows.toStdString()), "again").scenario, scenario);
    QVERIFY(scenarioFromHeader("time,value\n# 1\n").empty());
}

void TestBlowCsv::theHeaderNamesTheMethod() {
    const Example& example = defaultExample();
    const std::string header = scenarioHeader(example.text, "method lattice, 500 segments");
    QVERIFY(header.find("# # Solved by method lattice, 500 segments.\n") != std::string::npos);
    QCOMPARE(parseScenario(scenarioFromHeader(header), "again").scenario,
             parseScenario(example.text, example.name).scenario);
}

void TestBlowCsv::aByteOrderMarkStaysOutOfTheHeader() {
    // In the middle of the lines it would be part of a key.
    const Example& example = defaultExample();
    const std::string header = scenarioHeader("\xEF\xBB\xBF" + std::string(example.text), "method exact");
    QCOMPARE(parseScenario(scenarioFromHeader(header), "again").scenario,
             parseScenario(example.text, example.name).scenario);
}

QTEST_GUILESS_MAIN(TestBlowCsv)
#include "tst_blow_csv.moc"
