// SPDX-License-Identifier: GPL-3.0-or-later
// Exponential sums: their terms against what they stand for, and the search for their first zero.
#include <QTest>

#include "core/wave/exact/exponential_course.h"
#include "core/wave/exact/exponential_sum.h"
#include "core/wave/exact/exponential_zero.h"
#include "tests/support/scene.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

using Sum = ExponentialSum<3>;

constexpr LineRates<3> rates{0.7, 5, 1.9};

Coefficients someTerms(Chance& chance, unsigned most) {
    Coefficients terms;
    terms.count = int(chance.below(most + 1));
    for (int m = 0; m < terms.count; ++m) terms.c[m] = 2 * chance.fraction() - 1;
    return terms;
}

/// A constant and up to three decays of each rate.
Sum someDecays(Chance& chance) {
    Sum f = Sum::zero(chance.logarithmic(0.01, 20));
    f.rates = &rates;
    if (chance.oneIn(2)) f.c0 = 2 * chance.fraction() - 1;
    for (Coefficients& decays : f.decays) decays = someTerms(chance, 3);
    return f;
}

/// A sum of up to three terms of each kind.
Sum someSum(Chance& chance) {
    Sum f = someDecays(chance);
    if (chance.oneIn(3)) f.makeCurved().c1 = (2 * chance.fraction() - 1) / f.length;
    if (chance.oneIn(2))
        for (Coefficients& rises : f.makeCurved().rises) rises = someTerms(chance, chance.below(3));
    if (chance.oneIn(3))
        f.makeCurved().hammer = {chance.fraction(), chance.fraction() - 0.5, chance.fraction(), true};
    return f;
}

/// c0 + c1 x + Σ … term by term, as the definitions say.
double bySum(const Sum& f, double x) {
    const auto phi = [](int m, double y) { return std::exp(-y) * std::pow(y, m) / std::tgamma(m + 1.0); };
    double sum = f.c0;
    const auto addDecays = [&](const Coefficients& terms, double rate) {
        for (int m = 0; m < terms.count; ++m) sum += terms.c[m] * phi(m, rate * x);
    };
    const auto addRises = [&](const Coefficients& terms, double rate) {
        for (int m = 0; m < terms.count; ++m) {
            double omega = 1;
            for (int k = 0; k <= m; ++k) omega -= phi(k, rate * x);
            sum += terms.c[m] * omega;
        }
    };
    for (std::size_t i = 0; i < rates.size(); ++i) {
        addDecays(f.decays[i], rates[i]);
        if (f.isCurved) addRises(f.curve.rises[i], rates[i]);
    }
    if (!f.isCurved) return sum;
    const double pi = 3.141592653589793;
    const HammerTerms& hammer = f.curve.hammer;
    return sum + f.curve.c1 * x + hammer.sine * std::sin(pi * x) + hammer.cosine * std::cos(pi * x) +
           hammer.decay * std::exp(-x);
}

}  // namespace

class TestExponentialSum : public QObject {
    Q_OBJECT

  private slots:
    void termsAreThoseOfTheirDefinitions() {
        Chance chance(1);
        for (int i = 0; i < 2000; ++i) {
            const Sum f = someSum(chance);
            const double x = f.length * chance.fraction();
            QVERIFY(std::abs(f.value(x) - bySum(f, x)) < 1e-14);
            QVERIFY(f.mostValue() >= f.value(x) - 1e-14 && f.magnitude() >= std::abs(f.value(x)) - 1e-14);
            QVERIFY(!f.isAtLeastZero() || f.value(x) >= -1e-14);
            QVERIFY(!f.isAtMostZero() || f.value(x) <= 1e-14);
            QVERIFY(f.mostIntegral() >= f.integral(x) - 1e-14);
        }
    }

    void boundsSeeHowTermsCancel() {
        // φ_0 + φ_1 + … ≤ 1, and each ω_m is below the one before
        Sum f = Sum::zero(10);
        f.rates = &rates;
        f.c0 = -2;
        f.decays[0].count = 3;
        f.decays[0].c = {2, 1, 2};
        QCOMPARE(f.mostValue(), 0.0);
        f.c0 = 0;
        f.decays[0].c = {3, -4, 1};
        QCOMPARE(f.mostIntegral(), 3 / rates[0]);
        f.decays[0].c = {-3, 4, -2};
        QCOMPARE(f.mostIntegral(), 1 / rates[0]);
    }

    void whatIsSaidOfTheCourseHolds() {
        Chance chance(8);
        int falling = 0, rising = 0, convex = 0, concave = 0;
        for (int i = 0; i < 4000; ++i) {
            Sum f = someSum(chance);
            if (chance.oneIn(2)) f.length = std::min(f.length, 1.0);  // where a half sine may have one sign
            const ExponentialCourse course(f);
            falling += course.falls();
            rising += course.rises();
            convex += course.isConvex();
            concave += course.isConcave();
            constexpr int parts = 50;
            for (int k = 1; k < parts; ++k) {
                const double h = f.length / parts, x = k * h;
                const double step = f.value(x) - f.value(x - h);
                const double bend = f.value(x + h) - 2 * f.value(x) + f.value(x - h);
                QVERIFY(step >= course.leastSlope * h - 1e-13 && step <= course.mostSlope * h + 1e-13);
                QVERIFY(bend >= course.leastCurvature * h * h - 1e-13);
                QVERIFY(bend <= course.mostCurvature * h * h + 1e-13);
            }
        }
        QVERIFY2(falling > 100 && rising > 100 && convex > 100 && concave > 100,
                 qPrintable(QString("%1 %2 %3 %4").arg(falling).arg(rising).arg(convex).arg(concave)));
    }

    void theValuesAtTheEndsBoundTheIntegral() {
        Chance chance(9);
        int narrower = 0;
        for (int i = 0; i < 4000; ++i) {
            Sum f = someSum(chance);
            f.length = std::min(f.length, 2.0);
            const double most = mostIntegralByEnds(f, f.integral(f.length));
            narrower += most < f.mostIntegral() / 2;
            for (int k = 0; k <= 50; ++k) QVERIFY(most >= f.integral(f.length * k / 50) - 1e-15);
        }
        QVERIFY2(narrower > 1000, qPrintable(QString::number(narrower)));
    }

    void theValuesAtTheEndsOfALineAreItsIntegral() {
        Sum f = Sum::zero(2);
        f.rates = &rates;
        f.c0 = 1;
        f.makeCurved().c1 = -1;  // falls through zero in the middle
        QCOMPARE(mostIntegralByEnds(f, f.integral(f.length)), 0.5);
        f.c0 = -1;
        f.makeCurved().c1 = 1;  // and back to where it was
        QVERIFY(std::abs(mostIntegralByEnds(f, f.integral(f.length))) < 1e-13);
        f.c0 = 0;
        QCOMPARE(mostIntegralByEnds(f, f.integral(f.length)), 2.0);
    }

    void whatIsNotCurvedCopiesNoCurvedTerms() {
        Sum curved = Sum::zero(1);
        curved.rates = &rates;
        curved.makeCurved().c1 = 3;
        Sum straight = Sum::zero(1);
        straight.c0 = 1;
        Sum f = curved;
        f = straight;
        QCOMPARE(f.value(1), 1.0);
        QCOMPARE(f.makeCurved().c1, 0.0);
        f = curved;
        QCOMPARE(f.value(1), 3.0);
        f.trim(4);
        QVERIFY(!f.isCurved && f.isZero());
    }

    void theIntegralIsThatOfTheValues() {
        Chance chance(2);
        for (int i = 0; i < 200; ++i) {
            const Sum f = someSum(chance);
            constexpr int steps = 20000;  // Simpson's rule
            const double h = f.length / steps;
            double sum = f.value(0) + f.value(f.length);
            for (int k = 1; k < steps; ++k) sum += (k % 2 ? 4 : 2) * f.value(k * h);
            QVERIFY(std::abs(f.integral(f.length) - sum * h / 3) < 1e-8);
        }
    }

    void aFrontThatIsDroppedChangesNoValue() {
        Chance chance(3);
        for (int i = 0; i < 2000; ++i) {
            const Sum f = someSum(chance);
            const double from = f.length * chance.fraction(), x = (f.length - from) * chance.fraction();
            Sum rest = f;
            rest.dropFront(from);
            QVERIFY(std::abs(rest.value(x) - f.value(from + x)) < 1e-13);
            QCOMPARE(rest.length, f.length - from);
        }
    }

    void theResponseToARampOnSoftRockKeepsItsDigits() {
        // F = 2 (x − ω_0(ax)/a) → a x² for ax → 0: the sum errs by rounding of x, not of 1/a
        constexpr LineRates<3> soft{1e-6, 1e-5, 1e-7};
        Sum f = Sum::zero(1);
        f.rates = &soft;
        Sum::Curve& curve = f.makeCurved();
        curve.c1 = 2;
        curve.rises[0].count = 1;
        curve.rises[0].c[0] = -2 / soft[0];
        for (const double x : {0.1, 0.5, 1.0})
            QVERIFY(std::abs(f.value(x) - soft[0] * x * x * (1 - soft[0] * x / 3)) < 1e-15);
        QVERIFY(f.magnitude() < 5);  // though the coefficient is 2e6
    }

    void theFirstZeroIsFound() {
        Chance chance(4);
        int found = 0, none = 0, undecided = 0;
        SearchCount tally;
        for (int i = 0; i < 4000; ++i) {
            Sum f = someSum(chance);
            if (f.value(0) < 1e-6) continue;
            const auto zero = firstZero(f, 0, {}, tally);
            if (zero.undecided) {
                ++undecided;
                continue;
            }
            const double end = zero.found ? zero.u : f.length;
            zero.found ? ++found : ++none;
            if (zero.found) QVERIFY(std::abs(f.value(zero.u)) < 1e-13);
            for (int k = 0; k < 1000; ++k) QVERIFY(f.value(end * k / 1000) > -1e-14);
        }
        QVERIFY2(found > 400 && none > 400, qPrintable(QString("%1 found, %2 none").arg(found).arg(none)));
        QVERIFY2(undecided < 10, qPrintable(QString::number(undecided)));
        QVERIFY2(tally.samples < 12 * tally.searches, qPrintable(QString::number(tally.samples)));
    }

    void aFunctionThatStartsAtZeroGoesByItsSlopeOrCurvature() {
        SearchCount tally;
        const auto search = [&](double c1, double c2) {
            Sum f = Sum::zero(1);
            f.rates = &rates;
            f.makeCurved().c1 = c1;
            return firstZero(f, c2, {.startsAtZero = true}, tally);
        };
        QVERIFY(!search(1, 0).found);  // up
        QCOMPARE(search(-1, 0).u, 0.0);
        QVERIFY(search(-1, 0).found);
        QVERIFY(search(0, -4).found);  // tangential, and down
        QVERIFY(!search(0, 4).found && !search(0, 4).undecided);
        QVERIFY(search(1, -4).found);
        QCOMPARE(search(1, -4).u, 0.25);
    }

    void aTailBelowWhatCountsHasNoZero() {
        // e^−y (1 − y/200) + … vanishes at y = 200, where nothing is left of it
        Sum f = Sum::zero(1000);
        f.rates = &rates;
        f.decays[0].count = 2;
        f.decays[0].c[0] = 1;
        f.decays[0].c[1] = -1. / 200;
        f.decays[1].count = 1;
        f.decays[1].c[0] = 1e-3;
        SearchCount tally;
        QVERIFY(!firstZero(f, 0, {.negligible = 1e-19}, tally).found);
        QVERIFY2(tally.samples < 60, qPrintable(QString::number(tally.samples)));
    }
};

QTEST_GUILESS_MAIN(TestExponentialSum)
#include "tst_exponential_sum.moc"
