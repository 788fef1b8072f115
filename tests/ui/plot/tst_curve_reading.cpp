// SPDX-License-Identifier: GPL-3.0-or-later
// Values, slopes, means and integrals read off a curve.
#include <QTest>
#include <cmath>
#include <numbers>

#include "ui/plot/axis_view.h"
#include "ui/plot/curve_clip.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/view_statistics.h"

using namespace drillwave;

namespace {

QCPGraphDataContainer pointsOf(const QVector<QCPGraphData>& points) {
    QCPGraphDataContainer container;
    container.set(points, true);
    return container;
}

// Up from 0 to 2, a jump to −1 there, level until 5.
const QVector<QCPGraphData> jumping{{0, 0}, {2, 4}, {2, -1}, {5, -1}};

}  // namespace

class TestCurveReading : public QObject {
    Q_OBJECT

  private slots:
    void valuesAreReadOnTheChords();
    void integralsOfChordsAreExactAcrossJumps();
    void theWayBackIntegratesToTheOpposite();
    void aMillionChordsLoseNoDigits();
    void exactFunctionsGoBeforeChords();
    void unitsScaleSlopeAndIntegral();
    void theMeanIsOverWhatThereIsOfTheCurve();
    void extremesAreThoseOfThePartInView();
    void extremesOfAnExactFunctionAreNotThoseOfItsPoints();
    void crowdedPointsAreThinnedToTheirExtremes();
    void pointsInARowAreLeftOut();
    void linesAreCutAtTheEdges();
    void linesAreCutOnLogarithmicAxes();
    void rangesStayUsable_data();
    void rangesStayUsable();
};

void TestCurveReading::valuesAreReadOnTheChords() {
    const QCPGraphDataContainer points = pointsOf(jumping);
    QCOMPARE(chordValue(points, 0), 0.0);
    QCOMPARE(chordValue(points, 1), 2.0);
    QCOMPARE(chordValue(points, 2), -1.0);
    QCOMPARE(chordValue(points, 5), -1.0);
    QVERIFY(std::isnan(chordValue(points, -0.1)));
    QVERIFY(std::isnan(chordValue(points, 5.1)));
    QVERIFY(std::isnan(chordValue({}, 0)));
}

void TestCurveReading::integralsOfChordsAreExactAcrossJumps() {
    const QCPGraphDataContainer points = pointsOf(jumping);
    QCOMPARE(chordIntegral(points, 0, 2), 4.0);
    QCOMPARE(chordIntegral(points, 0, 5), 1.0);
    QCOMPARE(chordIntegral(points, 1, 3), 2.0);
    QCOMPARE(chordIntegral(points, 2, 3), -1.0);
    QCOMPARE(chordIntegral(points, 0.5, 1), 0.75);
    QCOMPARE(chordIntegral(points, -7, 9), 1.0);
    QCOMPARE(chordIntegral(points, 6, 9), 0.0);
    QCOMPARE(chordIntegral(points, -9, -6), 0.0);
    QCOMPARE(chordIntegral({}, 0, 1), 0.0);
}

void TestCurveReading::theWayBackIntegratesToTheOpposite() {
    QCOMPARE(chordIntegral(pointsOf(jumping), 3, 1), -2.0);
}

void TestCurveReading::aMillionChordsLoseNoDigits() {
    QVector<QCPGraphData> points;
    constexpr int count = 1'000'000;
    for (int i = 0; i <= count; ++i) points.append({i * 1e-6, i % 2 ? 0.1 : 0.3});
    // The mean of each chord is 0.2; what is left is the rounding of the keys.
    QVERIFY(std::abs(chordIntegral(pointsOf(points), 0, 1) - 0.2) < 1e-15);
}

void TestCurveReading::exactFunctionsGoBeforeChords() {
    CurveMeaning meaning;
    meaning.value = [](double x) { return x * x; };
    meaning.integral = [](double a, double b) { return (b * b * b - a * a * a) / 3; };
    const CursorReading reading = readCurve(pointsOf({{0, 0}, {3, 9}}), meaning, 1, 2);
    QCOMPARE(reading.yA, 1.0);
    QCOMPARE(reading.yB, 4.0);
    QCOMPARE(reading.slope, 3.0);
    QCOMPARE(reading.integral, 7.0 / 3);
    QCOMPARE(reading.mean, 7.0 / 3);
}

// Milliseconds and kilonewtons: the integral in N s, the slope in N/s.
void TestCurveReading::unitsScaleSlopeAndIntegral() {
    CurveMeaning meaning;
    meaning.integralFactor = 1;
    meaning.slopeFactor = 1e6;
    const CursorReading reading = readCurve(pointsOf({{0, 0}, {2, 4}}), meaning, 0, 2);
    QCOMPARE(reading.integral, 4.0);
    QCOMPARE(reading.mean, 2.0);
    QCOMPARE(reading.slope, 2e6);
    meaning.integralFactor = 1e-3;
    QCOMPARE(readCurve(pointsOf({{0, 0}, {2, 4}}), meaning, 0, 2).integral, 4e-3);
}

void TestCurveReading::theMeanIsOverWhatThereIsOfTheCurve() {
    const QCPGraphDataContainer points = pointsOf({{1, 2}, {3, 2}});
    QCOMPARE(readCurve(points, {}, 0, 9).mean, 2.0);
    QVERIFY(std::isnan(readCurve(points, {}, 0, 9).yA));
    QCOMPARE(readCurve(points, {}, 2, 2).mean, 2.0);
    QVERIFY(std::isnan(readCurve(points, {}, 2, 2).slope));
}

void TestCurveReading::extremesAreThoseOfThePartInView() {
    const QCPGraphDataContainer points = pointsOf(jumping);
    const ViewStatistics all = viewStatistics(points, {}, {-1, 9});
    QCOMPARE(all.begin, 0.0);
    QCOMPARE(all.end, 5.0);
    QCOMPARE(all.least, -1.0);
    QCOMPARE(all.leastAt, 2.0);
    QCOMPARE(all.largest, 4.0);
    QCOMPARE(all.integral, 1.0);
    QCOMPARE(all.mean, 0.2);
    // Between two points of a rising line the ends of the view are the extremes.
    const ViewStatistics part = viewStatistics(points, {}, {0.5, 1.5});
    QCOMPARE(part.least, 1.0);
    QCOMPARE(part.largest, 3.0);
    QCOMPARE(part.largestAt, 1.5);
    QCOMPARE(part.mean, 2.0);
    QVERIFY(std::isnan(viewStatistics(points, {}, {6, 7}).least));
    QVERIFY(std::isnan(viewStatistics({}, {}, {0, 1}).mean));
}

void TestCurveReading::extremesOfAnExactFunctionAreNotThoseOfItsPoints() {
    CurveMeaning meaning;
    meaning.value = [](double x) { return std::sin(x); };
    QVector<QCPGraphData> line;
    for (double x = 0; x < 6; x += 0.4) line.append(QCPGraphData(x, std::sin(x)));
    const ViewStatistics all = viewStatistics(pointsOf(line), meaning, {0, 6});
    QVERIFY(std::abs(all.largestAt - std::numbers::pi / 2) < 1e-6);
    QVERIFY(std::abs(all.leastAt - 1.5 * std::numbers::pi) < 1e-6);
    QCOMPARE(all.largest, 1.0);
    QCOMPARE(all.least, -1.0);
    // An end of the view stays one.
    const ViewStatistics rising = viewStatistics(pointsOf(line), meaning, {0.1, 1.3});
    QCOMPARE(rising.leastAt, 0.1);
    QCOMPARE(rising.largestAt, 1.3);
    QCOMPARE(rising.largest, std::sin(1.3));
}

void TestCurveReading::crowdedPointsAreThinnedToTheirExtremes() {
    QVector<QPointF> line;
    for (int i = 0; i < 1000; ++i)
        line.append({10 + i * 1e-4, i == 300 ? 7.0 : i == 600 ? -7.0 : 0.1 * (i % 3)});
    line.append({12, 1});
    const QVector<QPointF> thinned = thinnedLine(line, 1);
    QCOMPARE(thinned, (QVector<QPointF>{line[0], line[300], line[600], line[999], line[1000]}));
    // A gap stays, and so do points that can be distinguished.
    const double none = std::nan("");
    const QVector<QPointF> apart{{0, 0}, {1, 1}, {2, none}, {3, 0}, {4, 1}};
    QCOMPARE(thinnedLine(apart, 1).size(), apart.size());
    QVERIFY(std::isnan(thinnedLine(apart, 1)[2].y()));
    QVERIFY(thinnedLine({}, 1).isEmpty());
}

void TestCurveReading::pointsInARowAreLeftOut() {
    QVector<QPointF> steps;
    for (int i = 0; i <= 1000; ++i) steps.append({double(i), 2});
    for (int i = 1000; i <= 2000; ++i) steps.append({double(i), 5 + 0.1 * (i - 1000)});
    QCOMPARE(thinnedLine(steps, 1), (QVector<QPointF>{{0, 2}, {1000, 2}, {1000, 5}, {2000, 105}}));
    // A line that bends slowly stays where it is.
    QVector<QPointF> bent;
    for (int i = 0; i <= 2000; ++i) bent.append({double(i), 200 * std::sin(i / 300.0)});
    const QVector<QPointF> thinned = thinnedLine(bent, 1);
    QVERIFY2(thinned.size() < 250, QByteArray::number(thinned.size()));
    QCOMPARE(thinned.last(), bent.last());
    for (qsizetype i = 0, k = 1; i < bent.size(); ++i) {
        while (thinned[k].x() < bent[i].x()) ++k;
        const QPointF from = thinned[k - 1], to = thinned[k];
        const double share = (bent[i].x() - from.x()) / (to.x() - from.x());
        QVERIFY(std::abs(from.y() + share * (to.y() - from.y()) - bent[i].y()) < 0.051);
    }
    // One that turns back keeps where it turns.
    const QVector<QPointF> loop{{0, 0}, {5, 5}, {10, 10}, {5, 10}, {0, 10}};
    QCOMPARE(thinnedLine(loop, 1), (QVector<QPointF>{{0, 0}, {10, 10}, {5, 10}, {0, 10}}));
}

void TestCurveReading::linesAreCutAtTheEdges() {
    QCustomPlot plot;
    plot.xAxis->setRange(1, 9);
    plot.yAxis->setRange(-1, 1);
    // In from the left, out at the top, in again, out to the right.
    const auto line =
        clippedLine(pointsOf({{0, 0}, {4, 0}, {5, 2}, {6, 0}, {10, 0}}), *plot.xAxis, *plot.yAxis);
    const double nan = std::nan("");
    const QVector<QCPGraphData> wanted{{1, 0}, {4, 0}, {4.5, 1}, {4.5, nan}, {5.5, 1}, {6, 0}, {9, 0}};
    QCOMPARE(line.size(), wanted.size());
    for (qsizetype i = 0; i < line.size(); ++i) {
        QCOMPARE(line[i].key, wanted[i].key);
        QCOMPARE(std::isnan(line[i].value), std::isnan(wanted[i].value));
        if (!std::isnan(line[i].value)) QCOMPARE(line[i].value, wanted[i].value);
    }
    QVERIFY(clippedLine(pointsOf({{2, 5}, {8, 5}}), *plot.xAxis, *plot.yAxis).isEmpty());
}

void TestCurveReading::linesAreCutOnLogarithmicAxes() {
    QCustomPlot plot;
    plot.yAxis->setScaleType(QCPAxis::stLogarithmic);
    plot.yAxis->setRange(1, 100);
    plot.xAxis->setRange(0, 4);
    // Straight on screen: a power law, which crosses 100 half way between 10 and 1000.
    const auto line = clippedLine(pointsOf({{0, 10}, {2, 1000}, {4, 0}}), *plot.xAxis, *plot.yAxis);
    QVERIFY(line.size() >= 2);
    QCOMPARE(line[0].value, 10.0);
    QVERIFY(std::abs(line[1].key - 1) < 1e-12);
    QCOMPARE(line[1].value, 100.0);
}

void TestCurveReading::rangesStayUsable_data() {
    QTest::addColumn<double>("lower");
    QTest::addColumn<double>("upper");
    QTest::addColumn<bool>("linear");
    QTest::addColumn<bool>("logarithmic");
    const double infinity = std::numeric_limits<double>::infinity();
    QTest::newRow("ordinary") << 1.0 << 2.0 << true << true;
    QTest::newRow("across zero") << -1.0 << 2.0 << true << false;
    QTest::newRow("infinite") << 0.0 << infinity << false << false;
    QTest::newRow("no number") << std::nan("") << 1.0 << false << false;
    QTest::newRow("too fine for doubles") << 1.0 << 1 + 1e-13 << false << false;
    QTest::newRow("fine") << 1.0 << 1 + 1e-11 << true << true;
    QTest::newRow("huge") << 1.0 << 1e101 << false << false;
    QTest::newRow("empty") << 0.0 << 0.0 << false << false;
}

void TestCurveReading::rangesStayUsable() {
    QFETCH(double, lower);
    QFETCH(double, upper);
    QFETCH(bool, linear);
    QFETCH(bool, logarithmic);
    QCPRange wanted;
    wanted.lower = lower;
    wanted.upper = upper;
    const QCPRange present(3, 4);
    QCOMPARE(usableRange(wanted, present, QCPAxis::stLinear) != present, linear);
    QCOMPARE(usableRange(wanted, present, QCPAxis::stLogarithmic) != present, logarithmic);
}

QTEST_MAIN(TestCurveReading)
#include "tst_curve_reading.moc"
