// SPDX-License-Identifier: GPL-3.0-or-later
// A blow given by points: what the rounding of the points does to e is part of the stated error.
#include <QTest>

#include "core/wave/exact/exact_solver.h"
#include "core/wave/exact/input_move.h"
#include "tests/support/scene.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// The same blow in other units of time and force, from another origin.
PulseForce inOtherUnits(const std::vector<TablePoint>& points, double time, double force, double origin) {
    std::vector<TablePoint> scaled;
    for (const TablePoint& point : points)
        scaled.push_back({origin + time * point.time, force * point.force});
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tablePoints = TablePoints(std::move(scaled));
    return drillwave::pulseForceOf(scenario);
}

}  // namespace

class TestTableBlows : public QObject {
    Q_OBJECT

  private slots:
    /// Rounding that no bound of the march itself knows of: it was twice the stated error.
    void unitsOfTheTableChangeNoMoreThanIsStated() {
        Chance chance(41);
        ExactSolver solver;
        int compared = 0;
        for (unsigned i = 0; i < 20; ++i) {
            const std::vector<TablePoint> points = tablePoints({.points = 20'000, .seed = i});
            const Groups groups{chance.logarithmic(1, 5), 1e-3, chance.logarithmic(0.2, 0.5), 0};
            const Impact given = solver.solve(problemOf(inOtherUnits(points, 1, 1, 0), groups), Detail::cor);
            QCOMPARE(given.outcome, Outcome::rebounded);
            if (given.growth > coveredGrowth) continue;
            for (int k = 0; k < 20; ++k) {
                const PulseForce other =
                    inOtherUnits(points, chance.logarithmic(1e-6, 1e3), chance.logarithmic(1e-3, 1e6), 0);
                const Impact impact = solver.solve(problemOf(other, groups), Detail::cor);
                ++compared;
                const double difference = std::abs(impact.cor - given.cor);
                QVERIFY2(difference <= impact.corError + given.corError,
                         ("table " + std::to_string(i) + ": " + formatNumber(difference) + " of " +
                          formatNumber(impact.corError))
                             .c_str());
            }
        }
        QVERIFY2(compared > 300, std::to_string(compared).c_str());
    }

    void otherShapesHaveNoPoints() {
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::halfSine, PulseShape::piston})
            QCOMPARE(drillwave::pulseForceOf(shape, 2).rounding, 0.0);
        QVERIFY(inOtherUnits(tablePoints({}), 1, 1, 0).rounding < 1e-14);
    }
};

QTEST_GUILESS_MAIN(TestTableBlows)
#include "tst_table_blows.moc"
