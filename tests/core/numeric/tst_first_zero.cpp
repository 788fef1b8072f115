// SPDX-License-Identifier: GPL-3.0-or-later
// The first zero of a polynomial is found wherever it lies, and none is found where there is none.
#include "core/numeric/first_zero.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace drillwave;

namespace {

std::vector<double> exponentialSeries(double rate, double shift) {
    std::vector<double> c{1};
    while (c.size() < 24) c.push_back(c.back() * rate / double(c.size()));
    c[0] += shift;
    return c;
}

Zero<double> firstZeroOf(const std::vector<double>& c, double start = 0) {
    SearchCount count;
    return firstZero(c.data(), int(c.size()), 1.0, count, start);
}

}  // namespace

class TestFirstZero : public QObject {
    Q_OBJECT

  private slots:
    void everyFirstRootIsFound();
    void aDipAboveZeroIsNone_data();
    void aDipAboveZeroIsNone();
    void aDecayCrossesItsLevel();
    void rootsAtTheStartAreDividedOut();
    void theSearchGoesOnBehindAZero();
    void aSearchEndsWithTheStepThatIsExact();
};

// Products of linear factors and of dips that stay above zero: the roots are known.
void TestFirstZero::everyFirstRootIsFound() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-1, 2), unit(0, 1);
    int found = 0;
    for (int n = 0; n < 20000; ++n) {
        std::vector<double> c{1};
        double first = 2;
        const auto multiply = [&c](double a0, double a1, double a2) {
            c.resize(c.size() + 2);
            for (std::size_t k = c.size(); k-- > 0;)
                c[k] = a0 * c[k] + (k > 0 ? a1 * c[k - 1] : 0) + (k > 1 ? a2 * c[k - 2] : 0);
        };
        for (int factor = 0; factor < 1 + n % 4; ++factor) {
            const double root = place(random);
            if (std::abs(root) < 0.01) continue;
            multiply(1, -1 / root, 0);
            if (root > 0) first = std::min(first, root);
        }
        const double middle = unit(random), height = 0.01 + unit(random);
        multiply(middle * middle + height, -2 * middle, 1);
        const Zero<double> zero = firstZeroOf(c);
        QVERIFY(!zero.undecided);
        if (std::abs(first - 1) < 1e-6) continue;
        QCOMPARE(zero.found, first < 1);
        if (!zero.found) continue;
        ++found;
        QVERIFY2(std::abs(zero.u - first) < 1e-6, qPrintable(QString::number(zero.u - first)));
    }
    QVERIFY(found > 5000);
}

void TestFirstZero::aDipAboveZeroIsNone_data() {
    QTest::addColumn<double>("height");
    for (const double height : {1e-1, 1e-4, 1e-8, 1e-12}) QTest::addRow("%g", height) << height;
}

void TestFirstZero::aDipAboveZeroIsNone() {
    QFETCH(double, height);
    const double middle = 0.4375;  // exact in squares
    QVERIFY(!firstZeroOf({middle * middle + height, -2 * middle, 1}).found);
    QVERIFY(firstZeroOf({middle * middle - height, -2 * middle, 1}).found);
}

void TestFirstZero::aDecayCrossesItsLevel() {
    for (const double rate : {0.1, 0.5, 1.0, 2.0}) {
        for (const double at : {0.01, 0.3, 0.99}) {
            const Zero<double> zero = firstZeroOf(exponentialSeries(-rate, -std::exp(-rate * at)));
            QVERIFY(zero.found);
            QVERIFY2(std::abs(zero.u - at) < 1e-13 / rate, qPrintable(QString::number(zero.u - at)));
        }
        QVERIFY(!firstZeroOf(exponentialSeries(-rate, -0.9 * std::exp(-rate))).found);
    }
}

void TestFirstZero::rootsAtTheStartAreDividedOut() {
    QVERIFY(!firstZeroOf({0, 0, 1, 1}).found);
    QCOMPARE(firstZeroOf({0, -1, 1}).u, 0.0);
    const Zero<double> zero = firstZeroOf({0, 1, -2});
    QVERIFY(zero.found && std::abs(zero.u - 0.5) < 1e-15);
}

void TestFirstZero::theSearchGoesOnBehindAZero() {
    // −(u − 0.25)(u − 0.75): positive between its roots.
    const std::vector<double> c{-0.1875, 1, -1};
    const Zero<double> zero = firstZeroOf(c, 0.25);
    QVERIFY(zero.found && std::abs(zero.u - 0.75) < 1e-14);
    QVERIFY(!firstZeroOf({0.1875, -1, 1}, 0.75).found);
}

// A zero needs no further look once the bounds say that the last step has left nothing.
void TestFirstZero::aSearchEndsWithTheStepThatIsExact() {
    SearchCount line, parabola;
    const std::vector<double> falling{0.5, -1}, bent{0.5, -1, 0.01};
    QCOMPARE(firstZero(falling.data(), 2, 1.0, line).u, 0.5);
    QCOMPARE(line.samples, 1L);
    const double zero = 1 / (1 + std::sqrt(1 - 4 * 0.5 * 0.01));
    QVERIFY(std::abs(firstZero(bent.data(), 3, 1.0, parabola).u - zero) < 1e-15);
    QVERIFY(parabola.samples <= 4);
}

QTEST_GUILESS_MAIN(TestFirstZero)
#include "tst_first_zero.moc"
