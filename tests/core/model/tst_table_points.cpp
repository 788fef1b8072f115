// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a table: a value like a list, of which copies share the memory.
#include <QTest>

#include "core/model/scenario.h"

using namespace drillwave;

class TestTablePoints : public QObject {
    Q_OBJECT

  private slots:
    void aCopyOfAScenarioSharesItsPoints();
    void equalPointsAreEqualWhereverTheyAre();
    void noPointsAreOneValue();
    void pointsAreReadAsAList();
};

void TestTablePoints::aCopyOfAScenarioSharesItsPoints() {
    Scenario scenario;
    scenario.pulse.tablePoints = std::vector<TablePoint>(100000, TablePoint{1, 2});
    Scenario copy = scenario;
    copy.bitRock.gamma = 0.3;
    QVERIFY(copy.pulse.tablePoints.isSharedWith(scenario.pulse.tablePoints));
    QCOMPARE(&copy.pulse.tablePoints[99999], &scenario.pulse.tablePoints[99999]);
    copy.pulse.tablePoints = {{0, 0}, {1, 1}};
    QCOMPARE(scenario.pulse.tablePoints.size(), std::size_t{100000});
}

void TestTablePoints::equalPointsAreEqualWhereverTheyAre() {
    const TablePoints one{{0, 0}, {1, 2}};
    const TablePoints same{{0, 0}, {1, 2}};
    QVERIFY(one == same);
    QVERIFY(!one.isSharedWith(same));
    QVERIFY(one != TablePoints({{0, 0}, {1, 3}}));
    QVERIFY(one != TablePoints({{0, 0}}));
    Pulse pulse;
    pulse.tablePoints = one;
    Pulse other;
    other.tablePoints = same;
    QVERIFY(pulse == other);
}

void TestTablePoints::noPointsAreOneValue() {
    const TablePoints none;
    const TablePoints emptied = std::vector<TablePoint>();
    QVERIFY(none.empty() && none.size() == 0 && none.begin() == none.end());
    QVERIFY(none == emptied);
    QVERIFY(none != TablePoints({{0, 0}}));
}

void TestTablePoints::pointsAreReadAsAList() {
    const TablePoints points{{0, 5}, {1, 6}, {3, 0}};
    QCOMPARE(points.front().force, 5.0);
    QCOMPARE(points.back().time, 3.0);
    QCOMPARE(points[1].force, 6.0);
    double sum = 0;
    for (const TablePoint& point : points) sum += point.force;
    QCOMPARE(sum, 11.0);
}

QTEST_GUILESS_MAIN(TestTablePoints)
#include "tst_table_points.moc"
