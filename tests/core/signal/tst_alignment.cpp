// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "core/signal/alignment.h"

using namespace drillwave;

namespace {

// A wave down and its reflection, as a gauge sees them.
double force(double t) {
    const auto pulse = [](double x) { return x > 0 && x < 1e-4 ? std::sin(M_PI * x / 1e-4) : 0; };
    return -250e3 * pulse(t - 3e-4) + 180e3 * pulse(t - 9e-4);
}

TablePoints recorded(double shift, double from, double to, double factor) {
    std::vector<TablePoint> points;
    for (int i = 0; i <= 3000; ++i) {
        const double t = from + (to - from) * i / 3000;
        points.push_back({t, factor * force(t + shift)});
    }
    return points;
}

}  // namespace

class TestAlignment : public QObject {
    Q_OBJECT

  private slots:
    void aShiftedRecordIsFoundAgain_data();
    void aShiftedRecordIsFoundAgain();
    void nothingInCommonMovesNothing();
};

void TestAlignment::aShiftedRecordIsFoundAgain_data() {
    QTest::addColumn<double>("shift");
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addRow("in place") << 0.0 << 0.0 << 2e-3;
    QTest::addRow("late trigger") << 2.5e-4 << 0.0 << 1.5e-3;
    QTest::addRow("early trigger") << -1e-3 << 0.0 << 3e-3;
    QTest::addRow("times below zero") << 4.1e-4 << -5e-4 << 1e-3;
    QTest::addRow("longer than the blow") << 1e-4 << -5e-3 << 1e-2;
}

// The steps are at most 7.5 µs here; the parabola finds the place between to a twentieth of one.
void TestAlignment::aShiftedRecordIsFoundAgain() {
    QFETCH(double, shift);
    QFETCH(double, from);
    QFETCH(double, to);
    const double found = bestShift(recorded(shift, from, to, 0.8), force, 2e-3);
    const double step = std::max(to - from, 2e-3) / 2000;
    QVERIFY2(std::abs(found - shift) < step / 20, qPrintable(QString::number(found)));
}

void TestAlignment::nothingInCommonMovesNothing() {
    QCOMPARE(bestShift({{0, 0}, {1e-3, 0}}, force, 2e-3), 0.0);
    QCOMPARE(bestShift(
                 {{0, 1}, {1e-6, 1}}, [](double) { return -1.0; }, 2e-3),
             0.0);
}

QTEST_APPLESS_MAIN(TestAlignment)
#include "tst_alignment.moc"
