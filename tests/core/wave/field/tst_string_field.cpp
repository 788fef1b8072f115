// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the waves in hammer and string: against the uniform rod, the waves themselves, and their
// fronts.
#include <QTest>

#include "core/numeric/stride_search.h"
#include "core/wave/field/string_field.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/network_scenes.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// A hammer of two sections, and a string of three whose speeds differ: by what their joints say.
struct BentScene {
    Problem problem = struck();
    std::vector<double> joints{-0.2, -0.1, 0, 0.3, 0.7, 1};

    BentScene() {
        problem.sections = {{.impedance = 1.2, .transitTime = 0.3},
                            {.impedance = 0.9, .transitTime = 0.2},
                            {.impedance = 1.4, .transitTime = 1, .decay = 0.05},
                            {.impedance = 1, .transitTime = 2.5},
                            {.impedance = 1.8, .transitTime = 0.5}};
        hammerOf(problem).sections = 2;
        problem.law = {0.6, 0.2};
        problem.endTime = 30;
    }
};

}  // namespace

class TestStringField : public QObject {
    Q_OBJECT

  private slots:
    void stridesFindWhatASearchFinds() {
        Chance chance(5);
        for (int round = 0; round < 200; ++round) {
            std::vector<double> begins{0};
            while (begins.size() < 1 + chance.below(60)) begins.push_back(begins.back() + chance.fraction());
            std::size_t near = chance.below(static_cast<unsigned>(begins.size()));
            for (int i = 0; i < 20; ++i) {
                const double at = (begins.back() + 2) * chance.fraction() - 1;
                const auto behind = std::upper_bound(begins.begin(), begins.end(), at) - begins.begin();
                near = strideSearch(near, begins.size(), [&](std::size_t k) { return begins[k] <= at; });
                QCOMPARE(near, static_cast<std::size_t>(std::max<std::ptrdiff_t>(behind - 1, 0)));
            }
        }
    }

    void stringOfOneRodHasThePictureOfTheUniformRod_data() {
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        QTest::addColumn<double>("tau");
        QTest::addColumn<double>("delta");
        QTest::newRow("paper, Fig. 3") << 0.5 << 0.1 << 10.0 << 0.0;
        QTest::newRow("with a gap") << 1.0 << 0.4 << 5.0 << 0.3;
        QTest::newRow("elastic") << 0.5 << 1.0 << 3.0 << 0.0;
    }
    void stringOfOneRodHasThePictureOfTheUniformRod() {
        QFETCH(double, beta);
        QFETCH(double, gamma);
        QFETCH(double, tau);
        QFETCH(double, delta);
        const Groups groups{beta, gamma, tau, delta};
        const Impact exact = solve({PulseShape::rectangular, groups}, Detail::histories);
        const Problem problem = rodAsString(groups, exact.separationTime + tau);
        const Impact impact = solvedWithWaves(problem);
        QVERIFY(impact.waves);
        const StringField field(*impact.waves, {-0.5 / tau, 0, 1});
        // ends that no centre lies on a front with
        const RasterGrid grid{0, 1, 211, 0.0137, *problem.endTime - 0.0211, 307};
        for (const WaveQuantity quantity : {WaveQuantity::force, WaveQuantity::velocity}) {
            const WaveRaster rod = waveRaster(exact, quantity, grid), string = field.raster(quantity, grid);
            QCOMPARE(string.values.size(), rod.values.size());
            double largest = 0;
            for (std::size_t i = 0; i < rod.values.size(); ++i) {
                largest = std::max(largest, double(std::abs(rod.values[i])));
                QVERIFY2(std::abs(string.values[i] - rod.values[i]) < 1e-6F,
                         qPrintable(QString("cell %1: %2, not %3")
                                        .arg(i)
                                        .arg(double(string.values[i]))
                                        .arg(double(rod.values[i]))));
            }
            QVERIFY(largest > 0.9);
        }
    }

    void everyCellHoldsTheWavesAtItsCentre() {
        const BentScene scene;
        const Impact impact = solvedWithWaves(scene.problem);
        QVERIFY(impact.waves);
        const StringField field(*impact.waves, scene.joints);
        const RasterGrid grid{-0.2, 1, 97, -1, 30, 113};
        const WaveRaster force = field.raster(WaveQuantity::force, grid);
        const WaveRaster velocity = field.raster(WaveQuantity::velocity, grid);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const double x = grid.xi(column), t = grid.time(row);
                const std::size_t j = field.sectionAt(x);
                QVERIFY(scene.joints[j] <= x && x <= scene.joints[j + 1]);
                const double share = (x - scene.joints[j]) / (scene.joints[j + 1] - scene.joints[j]);
                QCOMPARE(force.values[grid.index(column, row)],
                         static_cast<float>(0 - impact.waves->force(j, share, t)));
                QCOMPARE(velocity.values[grid.index(column, row)],
                         static_cast<float>(impact.waves->velocity(j, share, t)));
                QCOMPARE(velocity.values[grid.index(column, row)],
                         static_cast<float>(field.value(WaveQuantity::velocity, x, t)));
            }
    }

    void beforeTheFirstTouchTheHammerMovesAndNothingPushes() {
        const BentScene scene;
        const Impact impact = solvedWithWaves(scene.problem);
        const StringField field(*impact.waves, scene.joints);
        const double v0 = 2;  // in F0/Z
        for (const double x : {-0.2, -0.15, -0.01, 0.01, 0.5, 1.0}) {
            QCOMPARE(field.value(WaveQuantity::force, x, -0.5), 0.0);
            QCOMPARE(field.value(WaveQuantity::velocity, x, -0.5), x < 0 ? v0 : 0.0);
        }
    }

    void besideHammerAndStringAndLaterNothingIsKnown() {
        const BentScene scene;
        const Impact impact = solvedWithWaves(scene.problem);
        const StringField field(*impact.waves, scene.joints);
        QCOMPARE(field.rear(), -0.2);
        const double end = field.end();
        for (const auto& [x, t] : {std::pair(-0.21, 1.0), std::pair(1.01, 1.0), std::pair(0.5, end + 0.01)})
            QVERIFY(std::isnan(field.value(WaveQuantity::force, x, t)));
        for (const double x : scene.joints) QVERIFY(!std::isnan(field.value(WaveQuantity::force, x, end)));
        const WaveRaster raster = field.raster(WaveQuantity::force, {-0.4, 1.2, 8, end - 5, end + 5, 10});
        for (int row = 0; row < 10; ++row)
            for (int column = 0; column < 8; ++column)
                QCOMPARE(std::isnan(raster.values[raster.grid.index(column, row)]),
                         row >= 5 || column == 0 || column == 7);
    }

    void forcesPassJointsWithoutALoss() {
        const BentScene scene;
        const Impact impact = solvedWithWaves(scene.problem);
        const StringField field(*impact.waves, scene.joints);
        Chance chance(11);
        double largest = 0;
        for (const std::size_t j : {1U, 3U, 4U})
            for (int i = 0; i < 200; ++i) {
                const double x = scene.joints[j], t = 30 * chance.fraction();
                const double behind = field.value(WaveQuantity::force, x, t);
                const double ahead = field.value(WaveQuantity::force, x + 1e-12, t);
                QVERIFY(std::abs(behind - ahead) < 1e-6);
                largest = std::max(largest, std::abs(behind));
            }
        QVERIFY(largest > 0.5);
    }

    // The picture has real lengths: in a section of twice the speed it is half as steep.
    void frontsRunWithTheSpeedOfTheSection() {
        const BentScene scene;
        const Impact impact = solvedWithWaves(scene.problem);
        const StringField field(*impact.waves, scene.joints);
        QCOMPARE(field.arrival(), 4.0);
        QCOMPARE(field.hammerRoundTrip(), 1.0);
        const std::vector<FrontRun> runs = field.frontRuns(0, 0, 7.9);
        QCOMPARE(runs.size(), std::size_t{2 + 2 + 3 + 3});
        int down = 0;
        double at = 0;  // when it has come so far
        for (const FrontRun& run : runs) {
            if (run.heading == Heading::fromBit || run.rear < 0) continue;
            QCOMPARE(run.timeAt(run.rear), at);
            at = run.timeAt(run.front);
            QCOMPARE(run.sectionAt(at), run.front);
            const double x = (run.rear + run.front) / 2;
            QVERIFY(std::abs(field.value(WaveQuantity::force, x, run.timeAt(x) - 1e-6)) < 1e-12);
            QVERIFY(field.value(WaveQuantity::force, x, run.timeAt(x) + 1e-6) < -0.5);
            ++down;
        }
        QCOMPARE(down, 3);
        QCOMPARE(at, field.arrival());
        // in the hammer it stops what moves
        int back = 0;
        for (const FrontRun& run : runs) {
            if (run.heading == Heading::toBit || run.front > 0) continue;
            const double x = (run.rear + run.front) / 2;
            QCOMPARE(field.value(WaveQuantity::velocity, x, run.timeAt(x) - 1e-6), 2.0);
            QVERIFY(field.value(WaveQuantity::velocity, x, run.timeAt(x) + 1e-6) < 1.5);
            ++back;
        }
        QCOMPARE(back, 2);
        for (const FrontRun& run : field.frontRuns(1, 17, 18)) {
            QVERIFY(std::max(run.timeAt(run.rear), run.timeAt(run.front)) >= 17);
            QVERIFY(std::min(run.timeAt(run.rear), run.timeAt(run.front)) <= 18);
        }
    }

    // The mechanism of a stall: a search among all cells of the waves, or a walk along them, for every pixel.
    void theWorkFollowsThePixelsAndNotTheBlow() {
        BentScene scene;
        for (const double end : {30.0, 1000.0}) {
            scene.problem.endTime = end;
            const Impact impact = solvedWithWaves(scene.problem);
            QVERIFY(impact.waves);
            const StringField field(*impact.waves, scene.joints);
            const WaveRaster raster = field.raster(WaveQuantity::force, {-0.2, 1, 300, 0, end, 200});
            const double perCell =
                static_cast<double>(raster.steps) / static_cast<double>(raster.values.size());
            const auto steps = static_cast<double>(impact.waves->clocks().size());
            // two waves; strides and bisection over the steps between two rows
            QVERIFY2(perCell < 2 * (3 + 2 * std::log2(2 + steps / 200)), QByteArray::number(perCell));
        }
    }
};

QTEST_GUILESS_MAIN(TestStringField)
#include "tst_string_field.moc"
