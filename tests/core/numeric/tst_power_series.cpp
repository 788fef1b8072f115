// SPDX-License-Identifier: GPL-3.0-or-later
// Power series on a piece of time, and their first zero, against polynomials whose roots are known.
#include <QTest>

#include "core/numeric/first_zero.h"
#include "tests/support/series.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

Zero<double> zeroOf(std::initializer_list<double> c, double end = 1) {
    SearchCount count;
    return firstZero(std::data(c), static_cast<int>(c.size()), end, count);
}

}  // namespace

class TestPowerSeries : public QObject {
    Q_OBJECT

  private slots:
    void theRestOfAPieceIsTheSameFunction() {
        const auto f = series(2, {1, -3, 2, 0.5});
        auto rest = f;
        rest.dropFront(0.7);
        QCOMPARE(rest.length, 2 - 0.7);
        for (const double x : {0.0, 0.4, 1.3}) QVERIFY(std::abs(rest.value(x) - f.value(x + 0.7)) < 1e-15);
    }

    void manyTermsMoveAsOneTermAfterTheOther() {
        for (int count = 1; count <= PowerSeries<double>::capacity; ++count) {
            std::vector<double> c, moved;
            for (int k = 0; k < count; ++k) c.push_back(std::cos(1.0 + k));
            // Σ c_k (u + v)^k: the coefficient of v^j is Σ_k C(k, j) u^(k − j) c_k
            const double u = 0.375;
            for (int j = 0; j < count; ++j) {
                double sum = 0, term = 1;
                for (int k = j; k < count; term *= u * (k + 1) / (k + 1 - j), ++k) sum += term * c[k];
                moved.push_back(sum);
            }
            moveBy(c.data(), count, u);
            for (int j = 0; j < count; ++j)
                QVERIFY(std::abs(c[j] - moved[j]) < 1e-13 * (1 + std::abs(moved[j])));
        }
    }

    void rescalingKeepsTheFunction() {
        auto f = series(2, {1, -3, 2, 0.5});
        const double before = f.value(0.9);
        f.rescale(0.25);
        QVERIFY(std::abs(f.value(0.9) - before) < 1e-14);
    }

    void productIntegralIsTheIntegralOfTheProduct() {
        const auto f = series(2, {1, 2});     // 1 + x
        const auto g = series(2, {0, 0, 4});  // x²
        QVERIFY(std::abs(PowerSeries<double>::productIntegral(f, g, 2.0) - (8.0 / 3 + 4)) < 1e-14);
    }

    void theFirstOfSeveralZerosIsFound() {
        // (u − 0.3)(u − 0.5)(u − 0.9), negative at 0, so its negative is searched
        const auto zero = zeroOf({0.135, -0.87, 1.7, -1});
        QVERIFY(zero.found);
        QVERIFY(std::abs(zero.u - 0.3) < 1e-14);
    }

    void aPolynomialWithoutZeroHasNone() {
        QVERIFY(!zeroOf({1, -1.9, 1}).found);  // minimum 0.0975
        QVERIFY(!zeroOf({1e-3, -0.06, 1}).found);
    }

    void aZeroBeyondTheEndIsNotFound() { QVERIFY(!zeroOf({1, -2}, 0.4).found); }

    void aZeroAtTheStartIsNotCountedWhenItRises() {
        QVERIFY(!zeroOf({0, 1, 1}).found);
        QVERIFY(!zeroOf({0, 0, 1}).found);
        const auto falls = zeroOf({0, -1, 1});
        QVERIFY(falls.found);
        QCOMPARE(falls.u, 0.0);
        const auto returns = zeroOf({0, 1, -2});
        QVERIFY(returns.found);
        QVERIFY(std::abs(returns.u - 0.5) < 1e-15);
    }

    void aSearchThatTouchesZeroWithoutFallingThroughFindsNone() {
        // (u − 0.5)² and its like with a residue of rounding: no part can be proven free in one step
        QVERIFY(!zeroOf({0.25 + 1e-15, -1, 1}).found);
        QVERIFY(!zeroOf({0.0625, -0.5, 1.5, -2, 1 + 1e-15}).undecided);  // (u − 0.5)⁴
        const auto dips = zeroOf({0.25 - 1e-10, -1, 1});
        QVERIFY(dips.found);
        QVERIFY(std::abs(dips.u - (0.5 - 1e-5)) < 1e-9);
    }

    void partsFindTheFirstFallThroughZero() {
        std::array<double, 4> c{0.135, -0.87, 1.7, -1};  // (0.3 − u)(0.5 − u)(0.9 − u)
        long samples = 0;
        const auto zero = firstZeroInParts(c.data(), 4, 1.0, 0.0, 1e-16, samples);
        QVERIFY(zero.found && std::abs(zero.u - 0.3) < 1e-14);
        const auto second =
            firstZeroInParts(c.data(), 4, 0.4, 0.35, 1e-16, samples);  // it starts below: at once
        QVERIFY(second.found);
        c[0] += 1;
        QVERIFY(!firstZeroInParts(c.data(), 4, 1.0, 0.0, 1e-16, samples).found);
    }

    void aSteepDecayOverALongPieceHasNoZero() {
        // e^{−6u} by its series: one curvature bound for the whole piece allows only tiny steps, and running
        // out of them must not count as a zero
        std::array<double, 30> c{};
        double term = 1;
        for (int k = 0; k < 30; ++k) {
            c[k] = term;
            term *= -6.0 / (k + 1);
        }
        SearchCount count;
        QVERIFY(!firstZero(c.data(), 30, 1.0, count).found);
        c[0] -= std::exp(-3.0);
        const auto zero = firstZero(c.data(), 30, 1.0, count);
        QVERIFY(zero.found);
        QVERIFY(std::abs(zero.u - 0.5) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(TestPowerSeries)
#include "tst_power_series.moc"
