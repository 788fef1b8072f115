// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolation and integration: exact for polynomials, spectral for smooth functions.
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/numeric/gauss_rule.h"
#include "core/numeric/piecewise_fit.h"

using namespace drillwave;

namespace {

template <class Function>
Chebyshev interpolant(const Function& f, double a, double b, std::size_t count) {
    std::vector<double> values;
    for (std::size_t j = 0; j < count; ++j) values.push_back(f(Chebyshev::node(a, b, j, count)));
    return {a, b, values};
}

double cubic(double x) {
    return 2 * x * x * x - 3 * x * x - 12 * x + 1;  // stationary at -1 and 2
}

}  // namespace

class TestChebyshev : public QObject {
    Q_OBJECT

  private slots:
    void polynomialsAreReproduced_data();
    void polynomialsAreReproduced();
    void theTailTellsTheErrorOfASmoothFunction();
    void everySecondFineNodeIsACoarseOne();
    void stationaryPointsAreTheZerosOfTheSlope();
    void gaussIntegratesPolynomialsExactly();
};

void TestChebyshev::polynomialsAreReproduced_data() {
    QTest::addColumn<int>("count");
    for (const int count : {4, 5, 9, 17}) QTest::addRow("%d nodes", count) << count;
}

void TestChebyshev::polynomialsAreReproduced() {
    QFETCH(int, count);
    const Chebyshev p = interpolant(cubic, -2, 3, static_cast<std::size_t>(count));
    for (double x = -2; x <= 3; x += 0.1) {
        // Values up to 20, slopes up to 36, of rounded sums of a few terms.
        QVERIFY(std::abs(p(x) - cubic(x)) < 1e-13);
        QVERIFY(std::abs(p.slope(x) - (6 * x * x - 6 * x - 12)) < 1e-12);
    }
}

void TestChebyshev::theTailTellsTheErrorOfASmoothFunction() {
    for (const double length : {0.5, 2.0, 5.0}) {
        const auto f = [](double x) { return std::exp(-x) * std::cos(3 * x); };
        const Chebyshev p = interpolant(f, 1, 1 + length, 17);
        double error = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double x = 1 + length * i / 1000;
            error = std::max(error, std::abs(p(x) - f(x)));
        }
        QVERIFY(error < 4 * p.tail() + 1e-15);
        QVERIFY(error > 1e-3 * p.tail() - 1e-15);
    }
}

void TestChebyshev::everySecondFineNodeIsACoarseOne() {
    for (std::size_t j = 0; j < 9; ++j)
        QVERIFY(std::abs(Chebyshev::node(0.2, 0.7, 2 * j, 17) - Chebyshev::node(0.2, 0.7, j, 9)) < 2e-16);
    QCOMPARE(Chebyshev::node(0.2, 0.7, 0, 9), 0.2);
    QCOMPARE(Chebyshev::node(0.2, 0.7, 8, 9), 0.7);
}

void TestChebyshev::stationaryPointsAreTheZerosOfTheSlope() {
    const std::vector<double> points = interpolant(cubic, -2, 3, 9).stationaryPoints();
    QCOMPARE(points.size(), std::size_t{2});
    QVERIFY(std::abs(points[0] + 1) < 1e-14 && std::abs(points[1] - 2) < 1e-14);
    const auto wave = [](double x) { return std::sin(6 * x); };
    QCOMPARE(interpolant(wave, 0, 1.5, 17).stationaryPoints().size(), std::size_t{3});
    QVERIFY(interpolant([](double x) { return x; }, 0, 1, 5).stationaryPoints().empty());
}

void TestChebyshev::gaussIntegratesPolynomialsExactly() {
    const GaussRule& rule = gaussRule();
    for (int power = 0; power <= 31; ++power) {
        double sum = 0;
        for (std::size_t i = 0; i < GaussRule::count; ++i)
            sum += rule.weights[i] * std::pow(rule.nodes[i], power);
        QVERIFY2(std::abs(sum * (power + 1) - 1) < 1e-14, QByteArray::number(power));
    }
}

QTEST_GUILESS_MAIN(TestChebyshev)
#include "tst_chebyshev.moc"
