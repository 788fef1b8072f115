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
    void nothingInCommonHasNoPlace();
    void aScaledAndLateRecordHasThatMisfit();
    void withoutACommonTimeThereIsNoMisfit();
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
    const double found = bestShift(recorded(shift, from, to, 0.8), force, 2e-3).value();
    const double step = std::max(to - from, 2e-3) / 2000;
    QVERIFY2(std::abs(found - shift) < step / 20, qPrintable(QString::number(found)));
}

void TestAlignment::nothingInCommonHasNoPlace() {
    QVERIFY(!bestShift({{0, 0}, {1e-3, 0}}, force, 2e-3));
    QVERIFY(!bestShift(
        {{0, 1}, {1e-6, 1}}, [](double) { return -1.0; }, 2e-3));
}

// In place a factor of 0.8 is a peak that is a fifth smaller, and an rms of a fifth of that of the two half
// sines, √(∑ p² w/2 / span). Shifted, the lag is what it was shifted by.
void TestAlignment::aScaledAndLateRecordHasThatMisfit() {
    constexpr double late = 1.3e-4, end = 2e-3, factor = 0.8;
    const TablePoints record = recorded(-late, 0, 3e-3, factor);
    const Misfit inPlace = misfitOf(record, -late, force, end).value();
    // Between points 1 µs apart, a hundredth of the half sine: (π/100)²/8 of the peak.
    QVERIFY(std::abs(inPlace.computedPeak - 250e3) < 1e-4 * 250e3);
    QVERIFY2(std::abs(inPlace.peakDifference + (1 - factor) * 250e3) < 2e-4 * 250e3,
             qPrintable(QString::number(inPlace.peakDifference)));
    const double span = end;  // the record goes on, and began before
    const double rms = (1 - factor) * std::sqrt((250e3 * 250e3 + 180e3 * 180e3) * 1e-4 / 2 / span);
    QVERIFY2(std::abs(inPlace.rms / rms - 1) < 2e-3, qPrintable(QString::number(inPlace.rms / rms)));
    // A step is 1.5 µs; the parabola finds the place between to a twentieth of one.
    QVERIFY2(std::abs(inPlace.lag.value()) < 1.5e-6 / 20, qPrintable(QString::number(*inPlace.lag)));
    const Misfit moved = misfitOf(record, 5e-5, force, end).value();
    QVERIFY2(std::abs(*moved.lag - (late + 5e-5)) < 1.5e-6 / 20, qPrintable(QString::number(*moved.lag)));
    QVERIFY(moved.rms > 3 * inPlace.rms);
}

void TestAlignment::withoutACommonTimeThereIsNoMisfit() {
    const TablePoints record{{0, 0}, {1e-3, 1}};
    QVERIFY(!misfitOf(record, 2e-3, force, 2e-3));
    QVERIFY(!misfitOf(record, -1e-3, force, 2e-3));
    QVERIFY(misfitOf(record, -0.9e-3, force, 2e-3));
}

QTEST_APPLESS_MAIN(TestAlignment)
#include "tst_alignment.moc"
