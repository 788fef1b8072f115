// SPDX-License-Identifier: GPL-3.0-or-later
// Contours: every point solves to its level, the lines hang together, and jumps are said to be jumps.
#include <QTest>

#include "core/study/map/contours.h"
#include "tests/support/map.h"
#include "tests/support/scenario.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const Scenario elastic = dimensionless(PulseShape::rectangular, {0.5, 1, 10, 0});

MapStudy superRebound(int count) {
    return mapOf(elastic, "beta=0.1:10:" + std::to_string(count) + ":log",
                 "delta=0:2:" + std::to_string(count));
}

}  // namespace

class TestContours : public QObject {
    Q_OBJECT

  private slots:
    void theBorderOfSuperReboundSolvesToOne();
    void theBorderSeparatesThePointsOfTheGrid();
    void sidesAndEndsOfALevelAreFound();
    void aLineCrossesEverySquareFromOneEdgeToAnother();
    void theContourThroughNoGapIsThatOfTheCurve();
    void nothingDependsOnTheNumberOfThreads();
    void aContourInSiIsThatOfTheScaledLevel();
    void aCoarseMapHasACoarseContour();
    void aJumpAcrossTheLevelIsSaidToBeOne();
    void aCrossingThatCannotBeSolvedBreaksTheLine();
    void aStopEndsTheSearch();
    void aLevelThatIsNotReachedHasNoLines();
};

void TestContours::theBorderOfSuperReboundSolvesToOne() {
    const MapStudy study = superRebound(120);
    const Contour contour = contourOf(study, solveMap(study, 2), 1, 2);
    QVERIFY(!contour.lines.empty());
    QVERIFY(contour.pointCount() > 200);
    QCOMPARE(contour.unplaced, std::uint64_t{0});
    QCOMPARE(contour.jumpCount(), std::uint64_t{0});
    QVERIFY(contour.worstResidual() < 1e-9);
    for (const ContourLine& line : contour.lines)
        for (const ContourPoint& point : line) {
            const double e = cor(PulseShape::rectangular, point.x, 1, 10, point.y);
            QCOMPARE(e, point.value);
            QVERIFY(std::abs(e - 1) < 1e-9);
        }
    // Smooth crossings take Brent's method some half dozen blows.
    QVERIFY(contour.solves < 12 * contour.pointCount());
}

void TestContours::sidesAndEndsOfALevelAreFound() {
    for (const bool isDescending : {false, true}) {
        const std::vector<double> ys =
            isDescending ? std::vector<double>{3, 2, 1} : std::vector<double>{1, 2, 3};
        const auto sideOfRows = [&](double first, double second, double last) {
            MapGrid grid({1, 2}, ys);
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t column = 0; column < 2; ++column)
                    grid.set(column, row, row == 0 ? first : row == 1 ? second : last);
            return sideOf(grid, 1);
        };
        QCOMPARE(sideOfRows(0, 0, 2), isDescending ? LevelSide::below : LevelSide::above);
        QCOMPARE(sideOfRows(2, 0, 0), isDescending ? LevelSide::above : LevelSide::below);
        QCOMPARE(sideOfRows(0, 2, 0), LevelSide::mixed);
        QCOMPARE(sideOfRows(2, 2, 2), LevelSide::mixed);
        QCOMPARE(sideOfRows(0, 0, 0), LevelSide::mixed);
    }
    Contour contour;
    QVERIFY(!extentOf(contour));
    contour.lines = {{{.x = 1, .y = 3}, {.x = 2, .y = 1}}, {{.x = 5, .y = 4}}};
    QCOMPARE(extentOf(contour)->lowest.x, 2.0);
    QCOMPARE(extentOf(contour)->highest.x, 5.0);
}

void TestContours::theBorderSeparatesThePointsOfTheGrid() {
    const MapStudy study = superRebound(60);
    const MapGrid grid = solveMap(study, 2);
    std::size_t crossings = 0;
    const auto crosses = [&](double a, double b) { return (a >= 1) != (b >= 1); };
    for (std::size_t row = 0; row < grid.rows(); ++row)
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            if (column > 0)
                crossings += crosses(grid.value(column - 1, row), grid.value(column, row)) ? 1 : 0;
            if (row > 0) crossings += crosses(grid.value(column, row - 1), grid.value(column, row)) ? 1 : 0;
        }
    QCOMPARE(contourOf(study, grid, 1, 2).pointCount(), std::uint64_t{crossings});
}

void TestContours::aLineCrossesEverySquareFromOneEdgeToAnother() {
    const MapStudy study = superRebound(60);
    const MapGrid grid = solveMap(study, 2);
    const Contour contour = contourOf(study, grid, 1, 2);
    const auto squareOf = [](std::span<const double> values, double value) {
        return static_cast<double>(std::ranges::upper_bound(values, value) - values.begin());
    };
    for (const ContourLine& line : contour.lines) {
        QVERIFY(line.size() >= 2);
        for (std::size_t n = 1; n < line.size(); ++n) {
            QVERIFY(std::abs(squareOf(grid.xs(), line[n].x) - squareOf(grid.xs(), line[n - 1].x)) <= 1);
            QVERIFY(std::abs(squareOf(grid.ys(), line[n].y) - squareOf(grid.ys(), line[n - 1].y)) <= 1);
        }
        // Closed, or from border to border.
        const auto isAtBorder = [&](const ContourPoint& p) {
            return p.x == grid.xs().front() || p.x == grid.xs().back() || p.y == grid.ys().front() ||
                   p.y == grid.ys().back();
        };
        QVERIFY(line.front() == line.back() || (isAtBorder(line.front()) && isAtBorder(line.back())));
    }
}

// Along one row at no gap, β = 0.5, γ = 1, τ = 10: e(δ) falls through 1 at 0.326877 and rises at 0.778532.
void TestContours::theContourThroughNoGapIsThatOfTheCurve() {
    const MapStudy study = mapOf(elastic, "beta=0.4:0.5:2", "delta=0:1:21");
    const Contour contour = contourOf(study, solveMap(study, 1), 1, 1);
    std::vector<double> gaps;
    for (const ContourLine& line : contour.lines)
        for (const ContourPoint& point : line)
            if (point.x == 0.5) gaps.push_back(point.y);
    std::ranges::sort(gaps);
    QCOMPARE(gaps.size(), std::size_t{2});
    QVERIFY(std::abs(gaps[0] - 0.326877) < 1e-6);
    QVERIFY(std::abs(gaps[1] - 0.778532) < 1e-6);
}

void TestContours::nothingDependsOnTheNumberOfThreads() {
    const MapStudy study = superRebound(70);
    const MapGrid grid = solveMap(study, 2);
    const Contour one = contourOf(study, grid, 1.1, 1);
    for (const int jobs : {2, 3, 8}) QVERIFY(contourOf(study, grid, 1.1, jobs) == one);
}

void TestContours::aContourInSiIsThatOfTheScaledLevel() {
    Scenario drilling;
    const char *x = "bit_rock.stiffness=50MN/m:1GN/m:30:log", *y = "bit_rock.gamma=0.1:1:30";
    const MapStudy inSi = mapOf(drilling, x, y, "peak_force", OutputUnits::si);
    const MapStudy inGroups = mapOf(drilling, x, y, "peak_force");
    const double scale = inSi.output.output->scale(scalesOf(drilling));
    const Contour si = contourOf(inSi, solveMap(inSi, 2), 1.2 * scale, 2);
    const Contour groups = contourOf(inGroups, solveMap(inGroups, 2), 1.2, 2);
    QVERIFY(si.pointCount() > 10);
    QCOMPARE(si.pointCount(), groups.pointCount());
    QVERIFY(si.worstResidual() < 1e-9 * 1.2 * scale);
    for (std::size_t n = 0; n < si.lines.front().size(); ++n) {
        // Both are within 1e-11 of the level, and the force changes by about as much as the stiffness.
        const ContourPoint &a = si.lines.front()[n], &b = groups.lines.front()[n];
        QVERIFY(std::abs(a.x - b.x) <= 1e-8 * b.x && std::abs(a.y - b.y) <= 1e-8);
    }
}

void TestContours::aCoarseMapHasACoarseContour() {
    const MapStudy study = superRebound(129);
    std::stop_source stop;
    const MapGrid coarse = solveMap(study, 2, stop.get_token(), [&](const MapGrid& soFar) {
        if (soFar.stride() > 0) stop.request_stop();
    });
    QVERIFY(coarse.stride() > 1);
    const Contour contour = contourOf(study, coarse, 1, 2);
    QVERIFY(contour.pointCount() > 10);
    QVERIFY(contour.worstResidual() < 1e-9);
    const MapStudy same = superRebound(static_cast<int>(128 / coarse.stride() + 1));
    QCOMPARE(contourOf(same, solveMap(same, 2), 1, 2).pointCount(), contour.pointCount());
    QVERIFY(contourOf(study, MapGrid(std::vector<double>(4), std::vector<double>(4)), 1, 1).lines.empty());
}

// The time of the last separation jumps where a further contact is lost.
void TestContours::aJumpAcrossTheLevelIsSaidToBeOne() {
    const MapStudy study = mapOf(elastic, "beta=0.1:10:40:log", "delta=0:1:40", "separation_time");
    const MapGrid grid = solveMap(study, 2);
    const double level = (grid.extent()->least + grid.extent()->largest) / 2;
    const Contour contour = contourOf(study, grid, level, 2);
    QVERIFY(contour.jumpCount() > 0);
    for (const ContourLine& line : contour.lines)
        for (const ContourPoint& point : line) {
            if (!point.isJump()) continue;
            // Enclosed to the last digits of the parameter, which is some hundred steps of the grid at most.
            QVERIFY(point.jumpWidth < 100 * 4 * std::numeric_limits<double>::epsilon());
            QVERIFY(point.residual > 1e-9);
        }
}

void TestContours::aCrossingThatCannotBeSolvedBreaksTheLine() {
    MapStudy study = superRebound(40);
    const MapGrid grid = solveMap(study, 2);
    study.workLimit = 1;  // the map was solved with more than the contour may take
    const Contour contour = contourOf(study, grid, 1, 2);
    QCOMPARE(contour.pointCount(), std::uint64_t{0});
    QVERIFY(contour.unplaced > 10);
    QVERIFY(contour.reason.text().find("polynomial pieces") != std::string::npos);
}

void TestContours::aStopEndsTheSearch() {
    const MapStudy study = superRebound(200);
    const MapGrid grid = solveMap(study, 2);
    std::stop_source stop;
    std::uint64_t placed = 0;
    const Contour contour =
        contourOf(study, grid, 1, 2, stop.get_token(), [&](std::uint64_t soFar, std::uint64_t all) {
            QVERIFY(soFar <= all);
            placed = soFar;
            stop.request_stop();
        });
    QVERIFY(contour.stopped);
    QVERIFY(contour.lines.empty());
    QVERIFY(placed > 0 && placed <= 16);
}

void TestContours::aLevelThatIsNotReachedHasNoLines() {
    const MapStudy study = superRebound(20);
    const Contour contour = contourOf(study, solveMap(study, 1), 5, 1);
    QVERIFY(contour.lines.empty());
    QCOMPARE(contour.solves, std::uint64_t{0});
    QVERIFY(!contour.stopped);
}

QTEST_GUILESS_MAIN(TestContours)
#include "tst_contours.moc"
