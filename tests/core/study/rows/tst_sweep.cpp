// SPDX-License-Identifier: GPL-3.0-or-later
// Grids of parameters: every row is the case it says, whatever the threads and parts.
#include <QTest>

#include <sstream>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/report/row_csv.h"
#include "core/study/rows/sweep_check.h"
#include "core/text/csv.h"
#include "core/wave/exact/exact_solver.h"
#include "tests/support/scenario.h"
#include "tests/support/sweep.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const Scenario blowInGroups = dimensionless(PulseShape::rectangular, {0.5, 0.1, 3, 0.2});

Scenario drilling() {
    Scenario scenario;
    scenario.drill.blowFrequency = 60;
    return scenario;
}

/// An adapter, a repeat of coupling and rod, a bit.
Scenario withString() {
    const auto section = [](const char* name, double length, double diameter) {
        Section made;
        made.name = name;
        made.length = length;
        made.diameter = diameter;
        return made;
    };
    Scenario scenario;
    scenario.form = ScenarioForm::string;
    scenario.drillString.hammer.sections = {section("", 0.5, 0.05)};
    scenario.drillString.parts = {
        {.repeat = 1, .group = false, .sections = {section("adapter", 0.45, 0.045)}},
        {.repeat = 2,
         .group = true,
         .sections = {section("coupling", 0.19, 0.056), section("rod", 3.66, 0.039)}},
        {.repeat = 1, .group = false, .sections = {section("bit", 0.13, 0.064)}}};
    return scenario;
}

std::string csvOf(const Sweep& sweep, int jobs, RowCounts* counts = nullptr) {
    std::string csv;
    RowCsv sink([&](std::string_view text) {
        csv += text;
        return true;
    });
    const RowCounts found = runSweep(sweep, jobs, {}, sink, [](const RowCounts&) {});
    if (counts) *counts = found;
    return csv;
}

using Rows = std::vector<std::vector<std::string>>;

Rows rowsOf(const std::string& csv) {
    std::istringstream in(csv);
    CsvReader reader(in);
    Rows rows;
    for (CsvRecord record; reader.next(record);) rows.push_back(record.cells);
    return rows;
}

/// Sets one cell as --set would, if the parameter applies.
void setCell(Scenario& scenario, const std::string& heading, const std::string& cell) {
    const std::size_t bracket = heading.find(" [");
    const std::string key = heading.substr(0, bracket);
    const KeptParameter parameter = findParameter(key);
    if (parameter && !parameter->applies(scenario)) return;
    const std::string unit = bracket == std::string::npos
                                 ? std::string()
                                 : " " + heading.substr(bracket + 2, heading.size() - bracket - 3);
    const std::string problem = assignText(scenario, key, cell + unit).text();
    if (!problem.empty()) qFatal("%s", problem.c_str());
}

/// The case of a row solved on its own: the shape first, then physical parameters, then groups.
ImpactSummary solvedAlone(const Scenario& base, const std::vector<std::string>& header,
                          const std::vector<std::string>& cells, std::size_t axes) {
    Scenario scenario = base;
    const auto rank = [](const std::string& heading) {
        if (heading == "pulse.shape") return 0;
        return heading.find('.') != std::string::npos ? 1 : 2;
    };
    for (const int wanted : {0, 1, 2})
        for (std::size_t a = 0; a < axes; ++a)
            if (rank(header[a]) == wanted) setCell(scenario, header[a], cells[a]);
    const Problem problem = problemOf(scenario);
    return summarize(ExactSolver().solve(problem, Detail::ledger), problem);
}

}  // namespace

class TestSweep : public QObject {
    Q_OBJECT

  private slots:
    void everyRowIsTheCaseItSays_data();
    void everyRowIsTheCaseItSays();
    void laterAxesRunFastest();
    void theBytesDoNotDependOnTheNumberOfThreads();
    void shardsPutTogetherAreTheWhole();
    void columnsInSiAreScaled();
    void thrustFollowsTheFrequencyOfTheRow();
    void unsolvedPointsAreEmptyAndCounted();
    void pointsThatAreNoScenarioAreEmptyAndCounted_data();
    void pointsThatAreNoScenarioAreEmptyAndCounted();
    void numbersBeyondDoublePrecisionAreNoResult();
    void aStopEndsTheSweep();
    void aWriterThatFailsEndsTheSweep();
    void impossibleSweepsAreRefused_data();
    void impossibleSweepsAreRefused();
};

void TestSweep::everyRowIsTheCaseItSays_data() {
    QTest::addColumn<Sweep>("sweep");
    const Scenario groups = blowInGroups;
    const Scenario rod = drilling();
    QTest::newRow("groups") << sweepOf(
        groups, {"beta=0.1:5:4:log", "gamma=0.1,1", "tau=0.4,3", "delta=0:1.5:4"}, "cor");
    QTest::newRow("shape outside") << sweepOf(
        groups, {"pulse.shape=half_sine,trapezoid,rigid_body", "beta=0.1,2"}, "cor");
    QTest::newRow("shape inside") << sweepOf(groups, {"beta=0.1,2", "pulse.shape=half_sine,trapezoid,piston"},
                                             "cor");
    QTest::newRow("shape after its parameter")
        << sweepOf(groups, {"pulse.rise=0.1,0.5", "pulse.shape=trapezoid"}, "cor");
    QTest::newRow("rod and groups") << sweepOf(rod, {"beta=0.3,0.9", "rod.diameter=32mm,45mm", "delta=0,0.4"},
                                               "cor");
    QTest::newRow("physical") << sweepOf(
        rod, {"rod.length=3m:6m:3", "bit_rock.stiffness=50MN/m:500MN/m:3:log", "pulse.duration=150us,300us"},
        "cor");
}

void TestSweep::everyRowIsTheCaseItSays() {
    QFETCH(Sweep, sweep);
    QVERIFY(problemsOf(sweep).empty());
    const Rows rows = rowsOf(csvOf(sweep, 2));
    QCOMPARE(rows.size(), pointCount(sweep) + 1);
    for (std::size_t r = 1; r < rows.size(); ++r) {
        const ImpactSummary alone = solvedAlone(sweep.base, rows[0], rows[r], sweep.axes.size());
        // Only rounding of the groups may differ: a dimensional case reaches them in another order.
        const double difference = *parseNumber(rows[r].back()) - alone.cor;
        QVERIFY2(std::abs(difference) <= 1e-12, qPrintable(QString("row %1: %2").arg(r).arg(difference)));
    }
}

void TestSweep::laterAxesRunFastest() {
    const std::string csv = csvOf(sweepOf(blowInGroups, {"beta=1,2", "gamma=0.5,1", "delta=0,3"}, "cor"), 1);
    QStringList points;
    for (const auto& row : rowsOf(csv))
        points << QString::fromStdString(row[0] + " " + row[1] + " " + row[2]);
    QCOMPARE(points.join('|'),
             QString("beta gamma delta|1 0.5 0|1 0.5 3|1 1 0|1 1 3|2 0.5 0|2 0.5 3|2 1 0|2 1 3"));
}

void TestSweep::theBytesDoNotDependOnTheNumberOfThreads() {
    // More rows than one chunk, with the blow changing along the way.
    const Sweep sweep =
        sweepOf(drilling(), {"pulse.shape=rectangular,half_sine", "rod.length=2m:7m:40", "delta=0:1:30"},
                "cor,peak_force,separation_time,thrust", OutputUnits::si);
    const std::string alone = csvOf(sweep, 1);
    QCOMPARE(rowsOf(alone).size(), std::size_t{2401});
    for (const int jobs : {2, 3, 7}) QVERIFY(csvOf(sweep, jobs) == alone);
}

void TestSweep::shardsPutTogetherAreTheWhole() {
    Sweep sweep = sweepOf(blowInGroups, {"beta=0.1:10:37:log", "delta=0:1:41"}, "cor");
    const std::string whole = csvOf(sweep, 2);
    std::string parts;
    for (std::uint64_t index = 1; index <= 5; ++index) {
        sweep.shard = {index, 5};
        parts += csvOf(sweep, 2);
    }
    QVERIFY(parts == whole);
}

void TestSweep::columnsInSiAreScaled() {
    const Scenario base = drilling();
    const Scales scales = scalesOf(base);
    const Rows si = rowsOf(
        csvOf(sweepOf(base, {"bit_rock.gamma=0.1,1"}, "cor,peak_force,separation_time", OutputUnits::si), 1));
    const Rows plain =
        rowsOf(csvOf(sweepOf(base, {"bit_rock.gamma=0.1,1"}, "cor,peak_force,separation_time"), 1));
    QCOMPARE(si[0],
             (std::vector<std::string>{"bit_rock.gamma", "cor", "peak_force [N]", "separation_time [s]"}));
    QCOMPARE(plain[0], (std::vector<std::string>{"bit_rock.gamma", "cor", "peak_force", "separation_time"}));
    for (const std::size_t row : {1U, 2U}) {
        QCOMPARE(si[row][1], plain[row][1]);
        QCOMPARE(*parseNumber(si[row][2]), *parseNumber(plain[row][2]) * scales.force);
        QCOMPARE(*parseNumber(si[row][3]), *parseNumber(plain[row][3]) * scales.time);
    }
}

void TestSweep::thrustFollowsTheFrequencyOfTheRow() {
    const Rows rows = rowsOf(csvOf(sweepOf(drilling(), {"drill.blow_frequency=30Hz,90Hz"}, "cor,thrust"), 1));
    QCOMPARE(rows[0][2], std::string("thrust [N]"));
    QCOMPARE(*parseNumber(rows[1][2]), 30 * 51 * (1 + *parseNumber(rows[1][1])));
    QCOMPARE(*parseNumber(rows[2][2]), 90 * 51 * (1 + *parseNumber(rows[2][1])));
}

void TestSweep::unsolvedPointsAreEmptyAndCounted() {
    // At β = 1e-300 the contact lasts for 1e150 round trips: beyond every limit of work.
    RowCounts counts;
    const Rows rows = rowsOf(csvOf(sweepOf(blowInGroups, {"beta=1,1e-300,2"}, "cor,peak_force"), 2, &counts));
    QCOMPARE(counts.rows, std::uint64_t{3});
    QCOMPARE(counts.failed, std::uint64_t{1});
    QCOMPARE(rows[2], (std::vector<std::string>{"1e-300", "", ""}));
    QVERIFY(!rows[1][1].empty() && !rows[3][2].empty());
}

void TestSweep::pointsThatAreNoScenarioAreEmptyAndCounted_data() {
    QTest::addColumn<Sweep>("sweep");
    QTest::addColumn<QString>("solved");  // of each row
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const Sweep& sweep, const char* solved, const char* reason) {
        QTest::newRow(name) << sweep << solved << reason;
    };
    row("beyond one end", sweepOf(drilling(), {"rod.bore=10mm:60mm:6"}, "cor"), "111000",
        "rod.bore must be less than the diameter of 38 mm");
    row("in a combination", sweepOf(drilling(), {"rod.bore=10mm,30mm", "rod.diameter=25mm,50mm"}, "cor"),
        "1101", "rod.bore must be less than the diameter of 25 mm");
    row("inside a list",
        sweepOf(blowInGroups, {"pulse.shape=trapezoid", "pulse.rise=0.1,0.9,0.2", "beta=1,2"}, "cor"),
        "110011", "pulse.fall rise and fall together must not exceed 1");
    row("a parameter of one shape",
        sweepOf(blowInGroups, {"pulse.rise=0.1,0.5", "pulse.shape=trapezoid,triangular"}, "cor"), "1010",
        "pulse.rise does not apply here: only for a trapezoid; the shape is triangular");
    row("a place that a repeat leaves none",
        sweepOf(withString(), {"string.repeat=1:3:3", "string.7.length=1m,2m"}, "cor"), "000011",
        "string.7.length does not apply here: the string has only 4 sections");
    row("a place that a repeat makes another",
        sweepOf(withString(), {"string.repeat=1,2", "string.2.length=0.1m,0.2m", "string.4.length=0.3m"},
                "cor"),
        "1100", "string.2.length and string.4.length are the same section of a repeat");
    row("table without points", sweepOf(blowInGroups, {"pulse.shape=half_sine,table", "beta=1,2"}, "cor"),
        "1100", "pulse.points needs at least two points");
}

// One rule for all studies: impossible points are left empty, and all others are solved as single ones.
void TestSweep::pointsThatAreNoScenarioAreEmptyAndCounted() {
    QFETCH(Sweep, sweep);
    QFETCH(QString, solved);
    QFETCH(QString, reason);
    QVERIFY(problemsOf(sweep).empty());
    RowCounts counts;
    const Rows rows = rowsOf(csvOf(sweep, 2, &counts));
    QString found;
    for (std::size_t r = 1; r < rows.size(); ++r) found += rows[r].back().empty() ? '0' : '1';
    QCOMPARE(found, solved);
    QCOMPARE(counts.failed, std::uint64_t(solved.count('0')));
    QVERIFY2(counts.failures.front().reason.text().starts_with(reason.toStdString()),
             counts.failures.front().reason.text().c_str());
    if (isString(sweep.base)) return;
    for (std::size_t r = 1; r < rows.size(); ++r) {
        if (rows[r].back().empty()) continue;
        const double alone = solvedAlone(sweep.base, rows[0], rows[r], sweep.axes.size()).cor;
        QVERIFY(std::abs(*parseNumber(rows[r].back()) - alone) <= 1e-12);
    }
}

void TestSweep::numbersBeyondDoublePrecisionAreNoResult() {
    RowCounts counts;
    const Scenario reference = dimensionless(PulseShape::rigidBody);
    const Rows rows = rowsOf(csvOf(sweepOf(reference, {"tau=5e-324,10"}, "cor,peak_force"), 1, &counts));
    QCOMPARE(rows[1], (std::vector<std::string>{"5e-324", "", ""}));
    QVERIFY(!rows[2][2].empty());
    QCOMPARE(counts.failed, std::uint64_t{1});
    QVERIFY(counts.failures.front().reason.text().starts_with(
        "its numbers are beyond the range of double precision"));
}

void TestSweep::aStopEndsTheSweep() {
    // 1e12 points would take weeks.
    const Sweep sweep = sweepOf(blowInGroups, {"beta=0.1:10:1000000", "delta=0:1:1000000"}, "cor");
    std::stop_source source;
    RowCsv sink([](std::string_view) { return true; });
    const RowCounts counts = runSweep(sweep, 2, source.get_token(), sink, [&](const RowCounts& so) {
        if (so.rows > 3000) source.request_stop();
    });
    QCOMPARE(counts.end, WorkEnd::stopped);
    QVERIFY(counts.rows > 3000);
}

void TestSweep::aWriterThatFailsEndsTheSweep() {
    const Sweep sweep = sweepOf(blowInGroups, {"beta=0.1:10:1000000", "delta=0:1:1000000"}, "cor");
    int calls = 0;
    RowCsv sink([&](std::string_view) { return ++calls < 4; });
    const RowCounts counts = runSweep(sweep, 2, {}, sink, [](const RowCounts&) {});
    QCOMPARE(counts.end, WorkEnd::stopped);
    QCOMPARE(calls, 4);
}

void TestSweep::impossibleSweepsAreRefused_data() {
    QTest::addColumn<Sweep>("sweep");
    QTest::addColumn<QString>("reason");
    const Scenario groups = blowInGroups;
    const Scenario rod = drilling();
    QTest::newRow("one parameter twice")
        << sweepOf(groups, {"beta=1,2", "beta=3,4"}, "cor") << "beta and beta";
    QTest::newRow("two names of one thing")
        << sweepOf(rod, {"rod.length=3m,4m", "tau=1,2"}, "cor") << "rod.length and tau set the same thing";
    QTest::newRow("no meaning in groups")
        << sweepOf(groups, {"rod.length=3m,4m"}, "cor") << "set `tau` instead";
    QTest::newRow("no meaning for the shape")
        << sweepOf(groups, {"pulse.rise=0.1,0.2"}, "cor") << "only for a trapezoid";
    QTest::newRow("invalid all over")
        << sweepOf(rod, {"rod.bore=40mm:60mm:4"}, "cor")
        << "at rod.bore = 40 mm: rod.bore = 40 mm (must be less than the diameter";
    QTest::newRow("two places of one section")
        << sweepOf(withString(), {"string.3.length=2m,3m", "string.5.length=2m,3m"}, "cor")
        << "string.3.length and string.5.length are the same section of a repeat";
    QTest::newRow("name and place of one section")
        << sweepOf(withString(), {"string.3.length=2m,3m", "string.rod.length=2m,3m"}, "cor")
        << "string.3.length and string.rod.length set one section: section 3 of the string is called rod";
    QTest::newRow("a shape over a string")
        << sweepOf(withString(), {"pulse.shape=rectangular,half_sine"}, "cor")
        << "the axis pulse.shape does not apply here: only for a force instead of the hammer";
    QTest::newRow("too many points") << sweepOf(groups, {"beta=1:2:1000001", "delta=0:1:1000000"}, "cor")
                                     << "more than 1000000000000 points";
    QTest::newRow("SI without units")
        << sweepOf(groups, {"beta=1,2"}, "cor", OutputUnits::si) << "need a scenario in physical units";
    QTest::newRow("thrust without frequency")
        << sweepOf(Scenario(), {"beta=1,2"}, "thrust") << "needs drill.blow_frequency";
}

void TestSweep::impossibleSweepsAreRefused() {
    QFETCH(Sweep, sweep);
    QFETCH(QString, reason);
    const std::vector<Message> problems = problemsOf(sweep);
    QVERIFY(!problems.empty());
    const std::string told = problems.front().text();
    QVERIFY2(QString::fromStdString(told).contains(reason), told.c_str());
}

QTEST_GUILESS_MAIN(TestSweep)
#include "tst_sweep.moc"
