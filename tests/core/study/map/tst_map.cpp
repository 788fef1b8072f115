// SPDX-License-Identifier: GPL-3.0-or-later
// Maps: every point is the blow it says, whatever the threads, and none is solved twice.
#include <QTest>

#include <random>
#include <set>

#include "core/model/assignments.h"
#include "core/report/row_csv.h"
#include "core/study/map/map.h"
#include "core/study/map/map_rows.h"
#include "core/study/rows/sweep.h"
#include "core/wave/exact/exact_solver.h"
#include "tests/support/map.h"
#include "tests/support/scenario.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const Scenario blowInGroups = dimensionless(PulseShape::rectangular, {0.5, 0.1, 3, 0.2});

/// A row of rocks so soft that the solver gives up at the work limit, beside ones that it solves.
MapStudy partlyUnsolved(int count = 9) {
    MapStudy study = mapOf(blowInGroups, "beta=1e-4:10:" + std::to_string(count) + ":log",
                           "gamma=0.1:0.5:" + std::to_string(count));
    study.workLimit = 60;
    return study;
}

/// Solves only the point, with the blow set up as --set does it, and returns the output.
double solvedAlone(const MapStudy& study, double x, double y) {
    Scenario scenario = study.base;
    const bool yFirst = Assignments({study.x.key(), study.y.key()}).order().front() == 1;
    if (yFirst) study.y.assign(scenario, y);
    study.x.assign(scenario, x);
    if (!yFirst) study.y.assign(scenario, y);
    const Problem problem = problemOf(scenario);
    const Impact impact = ExactSolver().solve(problem, study.output.detail());
    if (impact.outcome != Outcome::rebounded) return std::nan("");
    const ImpactSummary summary = summarizeWithWaves(impact, problem);
    return *study.output.value({summary, scenario}, scalesOf(scenario));
}

bool isSame(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

std::string csvOf(const std::function<RowCounts(RowSink&)>& run) {
    std::string csv;
    RowCsv sink([&](std::string_view text) {
        csv += text;
        return true;
    });
    run(sink);
    return csv;
}

}  // namespace

class TestMap : public QObject {
    Q_OBJECT

  private slots:
    void everyPointIsTheBlowSolvedAlone_data();
    void everyPointIsTheBlowSolvedAlone();
    void theRowsAreThoseOfASweep_data();
    void theRowsAreThoseOfASweep();
    void nothingDependsOnTheNumberOfThreads();
    void coarsePointsComeFirstAndKeepTheirValues();
    void aPointThatIsNotThereIsShownByTheNearestOfACoarserGrid();
    void pointsWithoutASolutionSayWhy();
    void manyReasonsEndInOne();
    void aStoppedMapKeepsWhatIsThere();
    void pointsThatAreNoScenarioHaveAReason();
    void whatCannotBeMappedIsSaid_data();
    void whatCannotBeMappedIsSaid();
};

void TestMap::everyPointIsTheBlowSolvedAlone_data() {
    QTest::addColumn<MapStudy>("study");
    Scenario si;
    Scenario force;
    force.pulse.impulseFromForce = true;
    Scenario piston;
    piston.pulse.shape = PulseShape::piston;
    piston.pulse.piston.diameter = 0.06;
    Scenario trapezoid;
    trapezoid.pulse.shape = PulseShape::trapezoid;
    constexpr auto inSi = OutputUnits::si;
    QTest::newRow("groups") << mapOf(blowInGroups, "beta=0.05:20:80:log", "delta=0:2:60");
    QTest::newRow("groups, other way round") << mapOf(blowInGroups, "delta=0:2:60", "beta=0.05:20:80:log");
    QTest::newRow("stiffness and length")
        << mapOf(si, "bit_rock.stiffness=10MN/m:10GN/m:60:log", "rod.length=1m:12m:70");
    QTest::newRow("groups in units") << mapOf(si, "beta=0.05:20:60:log", "delta=0:2:70", "peak_force", inSi);
    QTest::newRow("what moves the impulse")
        << mapOf(force, "pulse.duration=100us:300us:50", "tau=1:10:50", "impulse", inSi);
    QTest::newRow("what moves the blow")
        << mapOf(piston, "rod.diameter=30mm:50mm:40", "pulse.length=200mm:600mm:40", "peak_force", inSi);
    QTest::newRow("shape of the blow") << mapOf(trapezoid, "pulse.fall=0.1:0.5:40", "pulse.rise=0:0.5:40");
    QTest::newRow("stress") << mapOf(si, "rod.bore=0mm:20mm:40", "bit_rock.gamma=0.1:1:40", "peak_tension",
                                     inSi);
    QTest::newRow("thrust") << mapOf(si, "drill.blow_frequency=30Hz:90Hz:40", "bit_rock.gap=0mm:2mm:40",
                                     "thrust");
    QTest::newRow("unsolved here and there") << partlyUnsolved(40);
}

// 20 000 points over all rows, drawn with a fixed seed.
void TestMap::everyPointIsTheBlowSolvedAlone() {
    QFETCH(MapStudy, study);
    QVERIFY(problemsOf(study).empty());
    const MapGrid grid = solveMap(study, 2);
    QVERIFY(grid.isComplete());
    std::mt19937 random(12345);
    int solved = 0;
    for (int n = 0; n < 2000; ++n) {
        const std::size_t column = random() % grid.columns(), row = random() % grid.rows();
        if (!grid.reason(column, row).isEmpty()) continue;
        ++solved;
        const double alone = solvedAlone(study, study.x.value(column), study.y.value(row));
        QVERIFY2(isSame(grid.value(column, row), alone),
                 qPrintable(QString("column %1, row %2").arg(column).arg(row)));
    }
    QVERIFY(solved > 500);
}

void TestMap::theRowsAreThoseOfASweep_data() {
    everyPointIsTheBlowSolvedAlone_data();
}

void TestMap::theRowsAreThoseOfASweep() {
    QFETCH(MapStudy, study);
    const Sweep sweep{.base = study.base,
                      .axes = {study.x, study.y},
                      .columns = {study.output},
                      .shard = {},
                      .workLimit = study.workLimit};
    const std::string swept =
        csvOf([&](RowSink& sink) { return runSweep(sweep, 2, {}, sink, [](const RowCounts&) {}); });
    const MapGrid grid = solveMap(study, 2);
    const std::string mapped = csvOf([&](RowSink& sink) { return giveRows(study, grid, sink); });
    QVERIFY(mapped == swept);
}

void TestMap::nothingDependsOnTheNumberOfThreads() {
    for (const MapStudy& study :
         {partlyUnsolved(30), mapOf(blowInGroups, "beta=0.05:20:101:log", "tau=1:10:57")}) {
        const MapGrid one = solveMap(study, 1);
        for (const int jobs : {2, 3, 8}) QVERIFY(solveMap(study, jobs) == one);
    }
}

void TestMap::coarsePointsComeFirstAndKeepTheirValues() {
    const MapStudy study = mapOf(blowInGroups, "beta=0.05:20:150:log", "delta=0:2:90");
    std::vector<std::size_t> strides;
    std::size_t before = 0;
    std::vector<double> coarse;
    const MapGrid grid = solveMap(study, 2, {}, [&](const MapGrid& soFar) {
        QVERIFY(soFar.done() > before);
        before = soFar.done();
        if (soFar.stride() == 0 || (!strides.empty() && strides.back() == soFar.stride())) return;
        strides.push_back(soFar.stride());
        for (std::size_t row = 0; row < soFar.rows(); row += soFar.stride())
            for (std::size_t column = 0; column < soFar.columns(); column += soFar.stride())
                QVERIFY(soFar.isThere(column, row));
        if (coarse.empty())
            for (std::size_t row = 0; row < soFar.rows(); row += soFar.stride())
                coarse.push_back(soFar.value(0, row));
    });
    QCOMPARE(strides, (std::vector<std::size_t>{4, 2, 1}));
    QCOMPARE(grid.coarsestStride(), std::size_t{4});
    // set() asserts that no point comes twice; here that as many came as there are.
    QCOMPARE(before, grid.size());
    for (std::size_t n = 0; n < coarse.size(); ++n) QCOMPARE(grid.value(0, 4 * n), coarse[n]);
}

void TestMap::aPointThatIsNotThereIsShownByTheNearestOfACoarserGrid() {
    MapGrid grid(std::vector<double>(100), std::vector<double>(100));
    QCOMPARE(grid.coarsestStride(), std::size_t{4});
    grid.set(8, 4, 1);
    grid.set(10, 6, 2);
    using Place = MapGrid::Place;
    QCOMPARE(grid.standIn(10, 6), (Place{10, 6}));
    QCOMPARE(grid.standIn(11, 7), (Place{10, 6}));
    QCOMPARE(grid.standIn(9, 7), (Place{8, 4}));
    QCOMPARE(grid.standIn(11, 4), (Place{8, 4}));
    QVERIFY(!grid.isThere(grid.standIn(0, 0).column, grid.standIn(0, 0).row));
    QCOMPARE(grid.stride(), std::size_t{0});
}

void TestMap::pointsWithoutASolutionSayWhy() {
    const MapStudy study = partlyUnsolved();
    const MapGrid grid = solveMap(study, 2);
    QVERIFY(grid.isComplete());
    std::uint64_t unsolved = 0;
    for (std::size_t row = 0; row < grid.rows(); ++row)
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            const bool hasReason = !grid.reason(column, row).isEmpty();
            QCOMPARE(hasReason, std::isnan(grid.value(column, row)));
            if (hasReason)
                QVERIFY(grid.reason(column, row).text().find("polynomial pieces") != std::string::npos);
            unsolved += hasReason ? 1 : 0;
        }
    QVERIFY(unsolved > 0 && unsolved < grid.size());
    QCOMPARE(grid.failed(), unsolved);
    QCOMPARE(grid.failures().size(), std::size_t{1});
    RowCsv sink([](std::string_view) { return true; });
    QCOMPARE(giveRows(study, grid, sink).failures, grid.failures());
}

void TestMap::manyReasonsEndInOne() {
    MapGrid grid(std::vector<double>(200), std::vector<double>(1));
    for (std::size_t n = 0; n < 200; ++n) grid.fail(n, 0, "reason " + std::to_string(n));
    QCOMPARE(grid.failures().size(), maximumMapReasons);
    QCOMPARE(grid.failures().back(), (RowFailure{"other reasons", 101}));
    QCOMPARE(grid.failed(), std::uint64_t{200});
    QCOMPARE(grid.reason(5, 0).text(), std::string("reason 5"));
    QCOMPARE(grid.reason(150, 0).text(), std::string("other reasons"));
}

// A map that would take for ever: a stop from the progress leaves at most what is in work.
void TestMap::aStoppedMapKeepsWhatIsThere() {
    const MapStudy study = mapOf(blowInGroups, "beta=0.05:20:2000:log", "delta=0:2:2000");
    std::stop_source stop;
    std::size_t done = 0;
    const MapGrid grid = solveMap(study, 2, stop.get_token(), [&](const MapGrid& soFar) {
        done = soFar.done();
        if (soFar.stride() > 0) stop.request_stop();
    });
    QCOMPARE(grid.done(), done);
    QVERIFY(!grid.isComplete());
    QCOMPARE(grid.stride(), grid.coarsestStride());
    QVERIFY(grid.failures().empty());
    std::size_t there = 0;
    for (std::size_t row = 0; row < grid.rows(); ++row)
        for (std::size_t column = 0; column < grid.columns(); ++column)
            if (grid.isThere(column, row)) {
                ++there;
                if (there % 50 == 0)
                    QCOMPARE(grid.value(column, row),
                             solvedAlone(study, study.x.value(column), study.y.value(row)));
            }
    QCOMPARE(there, done);
    std::string reason;
    struct Sink : RowSink {
        bool begin(const RowHeader&) override { return true; }
        bool take(const RowBlock&, std::string_view) override { return true; }
    } sink;
    QCOMPARE(giveRows(study, grid, sink).failed, grid.size() - done);
}

void TestMap::pointsThatAreNoScenarioHaveAReason() {
    const MapStudy study = mapOf(Scenario(), "rod.bore=0mm:60mm:13", "bit_rock.stiffness=10MN/m:20MN/m:4");
    QVERIFY(problemsOf(study).empty());
    const MapGrid grid = solveMap(study, 2);
    QVERIFY(grid.isComplete());
    for (std::size_t column = 0; column < grid.columns(); ++column)
        for (std::size_t row = 0; row < grid.rows(); ++row)
            QCOMPARE(grid.reason(column, row).isEmpty(), study.x.value(column) < 0.038);
    QCOMPARE(grid.failures().size(), std::size_t{1});
    QCOMPARE(grid.failures().front().reason.text(),
             std::string("rod.bore must be less than the diameter of 38 mm"));
    QCOMPARE(grid.failed(), std::uint64_t{5 * 4});
}

void TestMap::whatCannotBeMappedIsSaid_data() {
    QTest::addColumn<MapStudy>("study");
    QTest::addColumn<QString>("problem");
    QTest::newRow("a list") << mapOf(blowInGroups, "beta=1,2,3", "delta=0:1:3")
                            << "the axis beta of a map needs START:STOP:COUNT or START:STOP:COUNT:log";
    QTest::newRow("shapes") << mapOf(blowInGroups, "pulse.shape=rectangular,triangular", "delta=0:1:3")
                            << "the axis pulse.shape of a map needs START:STOP:COUNT or START:STOP:COUNT:log";
    QTest::newRow("too many")
        << mapOf(blowInGroups, "beta=1:2:4001", "delta=0:1:4000")
        << "the map has more than 16000000 points; take fewer, or use `drillwave sweep`, which has no limit";
    QTest::newRow("the same twice")
        << mapOf(Scenario(), "beta=1:2:4", "bit_rock.stiffness=10MN/m:20MN/m:4")
        << "the axes beta and bit_rock.stiffness set the same thing; vary one of them";
    QTest::newRow("no corner that is a scenario")
        << mapOf(Scenario(), "rod.bore=40mm:50mm:4", "bit_rock.stiffness=10MN/m:20MN/m:4")
        << "at rod.bore = 40 mm, bit_rock.stiffness = 10 MN/m: rod.bore = 40 mm (must be less than the "
           "diameter of 38 mm)";
    QTest::newRow("SI without units")
        << mapOf(blowInGroups, "beta=1:2:4", "delta=0:1:4", "peak_force", OutputUnits::si)
        << "SI columns need a scenario in physical units; this one is given by its dimensionless groups";
}

void TestMap::whatCannotBeMappedIsSaid() {
    QFETCH(MapStudy, study);
    QFETCH(QString, problem);
    const std::vector<Message> problems = problemsOf(study);
    QVERIFY(!problems.empty());
    QCOMPARE(QString::fromStdString(problems.front().text()), problem);
}

QTEST_GUILESS_MAIN(TestMap)
#include "tst_map.moc"
