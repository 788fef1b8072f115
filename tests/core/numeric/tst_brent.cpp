// SPDX-License-Identifier: GPL-3.0-or-later
// Roots and minima: found to the accuracy promised, also where the function jumps or is flat.
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/numeric/brent.h"

using namespace drillwave;

class TestBrent : public QObject {
    Q_OBJECT

  private slots:
    void aRootIsFoundToTheLastDigits_data();
    void aRootIsFoundToTheLastDigits();
    void theRootOfAJumpIsTheJump();
    void aRootAtAnEndIsThatEnd();
    void aMinimumIsFound_data();
    void aMinimumIsFound();
};

using Function = double (*)(double);

void TestBrent::aRootIsFoundToTheLastDigits_data() {
    QTest::addColumn<Function>("f");
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("root");
    QTest::newRow("straight line") << Function([](double x) { return x - 0.3; }) << -1.0 << 1.0 << 0.3;
    QTest::newRow("square root of two")
        << Function([](double x) { return x * x - 2; }) << 0.0 << 2.0 << std::numbers::sqrt2;
    QTest::newRow("theory section 5, beta1")
        << Function([](double x) { return std::exp(x) - 2 * x - 1; }) << 0.5 << 3.0 << 1.25643120862617;
    QTest::newRow("triple root, falling")
        << Function([](double x) { return -std::pow(x - 1, 3); }) << 0.0 << 1.7 << 1.0;
    QTest::newRow("steep") << Function([](double x) { return std::expm1(1e3 * (x - 0.1)); }) << 0.0 << 0.5
                           << 0.1;
}

void TestBrent::aRootIsFoundToTheLastDigits() {
    QFETCH(Function, f);
    QFETCH(double, a);
    QFETCH(double, b);
    QFETCH(double, root);
    // At a triple root f is zero within rounding over the cube root of it.
    const double tolerance = QByteArray(QTest::currentDataTag()).startsWith("triple") ? 1e-5 : 4e-15;
    QVERIFY(std::abs(brentRoot(f, a, f(a), b, f(b)) - root) <= tolerance);
}

void TestBrent::theRootOfAJumpIsTheJump() {
    const auto f = [](double x) { return x < 0.7 ? -1.0 : 2.0; };
    QVERIFY(std::abs(brentRoot(f, 0, f(0), 5, f(5)) - 0.7) <= 1e-14);
}

void TestBrent::aRootAtAnEndIsThatEnd() {
    const auto f = [](double x) { return x; };
    QCOMPARE(brentRoot(f, -1, -1, 0, 0), 0.0);
    QVERIFY(std::abs(brentRoot(f, 0, 0, 1, 1)) <= 1e-300);
}

void TestBrent::aMinimumIsFound_data() {
    QTest::addColumn<Function>("f");
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("x");
    QTest::newRow("parabola") << Function([](double x) { return (x - 2) * (x - 2); }) << 0.0 << 5.0 << 2.0;
    QTest::newRow("cosine") << Function([](double x) { return std::cos(x); }) << 2.0 << 4.0
                            << std::numbers::pi;
    QTest::newRow("angle") << Function([](double x) { return std::abs(x - 0.2); }) << -1.0 << 1.0 << 0.2;
    QTest::newRow("at the end") << Function([](double x) { return x; }) << 1.0 << 2.0 << 1.0;
}

void TestBrent::aMinimumIsFound() {
    QFETCH(Function, f);
    QFETCH(double, a);
    QFETCH(double, b);
    QFETCH(double, x);
    const Minimum minimum = brentMinimum(f, a, b);
    // A minimum is flat: its place is known to the square root of the rounding.
    QVERIFY(std::abs(minimum.x - x) <= 2e-8);
    QCOMPARE(minimum.value, f(minimum.x));
}

QTEST_GUILESS_MAIN(TestBrent)
#include "tst_brent.moc"
