// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture against the waves themselves: exact at every cell, sharp at any size, cheap at any length.
#include <QTest>
#include <cmath>
#include <random>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/history_reader.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// −g(t − ξτ) − r(t − (2 − ξ)τ) and g − r, from the definition.
double expected(const Impact& impact, WaveQuantity field, double xi, double t) {
    const double positive = WaveField(impact).positiveWave(xi, t),
                 negative = WaveField(impact).negativeWave(xi, t);
    return field == WaveQuantity::force ? positive + negative : negative - positive;
}

const Scene figure4a{PulseShape::rectangular, {0.5, 1, 10, 0}};

}  // namespace

class TestWaveRaster : public QObject {
    Q_OBJECT

  private slots:
    void readsWhatTheHistoriesSayWhereverItIsAsked() {
        RandomScenes scenes(engineeringDomain, 7);
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> share(0, 1);
        scenes.forEachSolved(140, Detail::histories, [&](const Scene& scene, const Impact& impact) {
            HistoryReader reader(impact);
            const double end = impact.separationTime + 3 * impact.roundTrip;
            for (int i = 0; i < 300; ++i) {
                const double s = i % 3 == 0 ? end * (1.1 * share(random) - 0.1) : end * i / 300;
                QVERIFY2(reader.incident(s) == incidentWave(impact, s), describe(scene).c_str());
                QVERIFY2(reader.reflected(s) == impactForce(impact, s) - incidentWave(impact, s),
                         describe(scene).c_str());
            }
            // On the pieces' own ends, where the histories jump.
            for (const auto& piece : impact.incident.pieces().first(
                     std::min<std::size_t>(impact.incident.pieces().size(), 500))) {
                const double s = timeOfRecorded(impact, piece.start);
                QCOMPARE(reader.incident(s), incidentWave(impact, s));
                QCOMPARE(reader.incident(std::nextafter(s, 0.0)),
                         incidentWave(impact, std::nextafter(s, 0.0)));
            }
        });
    }

    void everyCellHoldsTheFieldAtItsCentre() {
        RandomScenes scenes(engineeringDomain, 11);
        scenes.forEachSolved(40, Detail::histories, [](const Scene& scene, const Impact& impact) {
            const RasterGrid grid{
                0, 1, 37, -0.2 * impact.roundTrip, impact.separationTime + 2.3 * impact.roundTrip, 41};
            for (const WaveQuantity field : {WaveQuantity::force, WaveQuantity::velocity}) {
                const WaveRaster raster = waveRaster(impact, field, grid);
                for (int row = 0; row < grid.rows; ++row)
                    for (int column = 0; column < grid.columns; ++column)
                        QVERIFY2(
                            raster.values[grid.index(column, row)] ==
                                static_cast<float>(expected(impact, field, grid.xi(column), grid.time(row))),
                            describe(scene).c_str());
            }
        });
    }

    void jumpsStaySharpHoweverDeepOneLooks() {
        const Impact impact = solve(figure4a, Detail::histories);
        // The blow's front passes the middle of the rod at t = τ/2 = 5.
        for (double size = 1; size > 1e-9; size /= 10) {
            const RasterGrid grid{0.5, 0.5, 1, 5 - size, 5 + size, 200};
            const WaveRaster raster = waveRaster(impact, WaveQuantity::force, grid);
            for (int row = 0; row < grid.rows; ++row)
                QCOMPARE(raster.values[grid.index(0, row)], row < 100 ? 0.0F : -1.0F);
        }
    }

    void frontsRunWithTheWaveSpeed() {
        const Impact impact = solve(figure4a, Detail::histories);
        const RasterGrid grid{0, 1, 100, 0, 10, 100};
        const WaveRaster raster = waveRaster(impact, WaveQuantity::velocity, grid);
        // v = F0/Z between the fronts x = ct and x = c(t − t0).
        for (int row = 0; row < 100; ++row)
            for (int column = 0; column < 100; ++column) {
                const double behind = grid.time(row) - 10 * grid.xi(column);
                if (std::abs(behind) < 1e-9 || std::abs(behind - 1) < 1e-9) continue;
                QCOMPARE(raster.values[grid.index(column, row)], behind > 0 && behind < 1 ? 1.0F : 0.0F);
            }
    }

    void theReferenceCaseArrivesWithoutWaves() {
        const Impact impact = solve({PulseShape::rigidBody, {0.5, 0.3, 2, 0}}, Detail::histories);
        const RasterGrid grid{0, 1, 9, -4, 0, 7};
        for (const float force : waveRaster(impact, WaveQuantity::force, grid).values) QCOMPARE(force, 0.0F);
        // v0 = I0/m is F0/(Zτ)
        for (const float velocity : waveRaster(impact, WaveQuantity::velocity, grid).values)
            QCOMPARE(velocity, 0.5F);
    }

    void outsideTheRodThereIsNothing() {
        const Impact impact = solve(figure4a, Detail::histories);
        const WaveRaster raster = waveRaster(impact, WaveQuantity::force, {-1, 2, 3, 0, 30, 5});
        for (int row = 0; row < 5; ++row) {
            QVERIFY(std::isnan(raster.values[raster.grid.index(0, row)]));
            QVERIFY(!std::isnan(raster.values[raster.grid.index(1, row)]));
            QVERIFY(std::isnan(raster.values[raster.grid.index(2, row)]));
        }
    }

    // The mechanism of a stall: a search among all pieces, or a walk along all round trips, for every cell.
    void theWorkFollowsTheCellsAndNotTheBlow_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        QTest::addColumn<double>("tau");
        QTest::addColumn<double>("delta");
        QTest::addColumn<double>("roundTrips");
        const auto row = [](const char* name, PulseShape shape, Groups g, double roundTrips) {
            QTest::newRow(name) << static_cast<int>(shape) << g.beta << g.gamma << g.tau << g.delta
                                << roundTrips;
        };
        row("an ordinary blow", PulseShape::rectangular, {0.5, 0.1, 10, 0}, 4);
        row("a smooth blow", PulseShape::halfSine, {0.5, 0.1, 10, 0}, 4);
        row("a staircase", PulseShape::piston, {0.5, 0.1, 10, 0}, 4);
        row("stiff", PulseShape::rectangular, {1e6, 0.01, 10, 0}, 4);
        row("a soft spring", PulseShape::rectangular, {1e-4, 1, 5, 0}, 200);
        row("a short rod", PulseShape::halfSine, {0.5, 0.5, 0.05, 0.5}, 60);
        row("a gap of a million", PulseShape::rectangular, {0.5, 0.1, 10, 1e6}, 1.1e6);
        row("a gap of a million of a short rod", PulseShape::rectangular, {0.5, 0.1, 0.3, 1e6}, 1.1e6);
    }
    void theWorkFollowsTheCellsAndNotTheBlow() {
        QFETCH(int, shape);
        QFETCH(double, beta);
        QFETCH(double, gamma);
        QFETCH(double, tau);
        QFETCH(double, delta);
        QFETCH(double, roundTrips);
        const Impact impact =
            solve({static_cast<PulseShape>(shape), {beta, gamma, tau, delta}}, Detail::histories);
        QCOMPARE(impact.outcome, Outcome::rebounded);
        const RasterGrid grid{0, 1, 300, 0, roundTrips * impact.roundTrip, 200};
        const WaveRaster raster = waveRaster(impact, WaveQuantity::force, grid);
        const double perCell = static_cast<double>(raster.steps) / static_cast<double>(raster.values.size());
        // Two look-ups a cell; a walk of n pieces takes 2 log2(n) looks.
        QVERIFY2(perCell < 2 + 4 * std::log2(2.0 + static_cast<double>(impact.incident.pieces().size())),
                 QByteArray::number(perCell).constData());
    }
};

QTEST_GUILESS_MAIN(TestWaveRaster)
#include "tst_wave_raster.moc"
