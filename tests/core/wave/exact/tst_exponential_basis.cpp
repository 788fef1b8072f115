// SPDX-License-Identifier: GPL-3.0-or-later
// A stretch of contact in closed form: what it leaves of the waves that arrived.
#include "core/wave/exact/exponential_basis.h"

#include <QTest>
#include <cmath>

#include "tests/support/scene.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr ContactRates<double> rates{0.7, 5};

/// A ramp, a sine or both, and up to three decays of each rate.
ExponentialSum someCurvedWave(Chance& chance) {
    const auto some = [&] { return 2 * chance.fraction() - 1; };
    ExponentialSum g = ExponentialSum::zero(chance.logarithmic(0.01, 20));
    g.rates = &rates;
    g.c0 = some();
    for (Coefficients* terms : {&g.primary, &g.elastic}) {
        terms->count = static_cast<int>(chance.below(4));
        for (int m = 0; m < terms->count; ++m) terms->c[m] = some();
    }
    g.makeCurved().c1 = some() / g.length;
    if (chance.oneIn(2)) g.makeCurved().hammer = {some(), some(), some(), true};
    return g;
}

}  // namespace

class TestExponentialBasis : public QObject {
    Q_OBJECT

  private slots:
    void theImpulsesOfWhatIsLeftAreThoseOfItsSums() {
        ExponentialBasis basis;
        basis.begin(problemOf(Scene{PulseShape::halfSine, {rates.primary, 0.14, 10, 0}}), rates);
        Chance chance(11);
        for (int i = 0; i < 2000; ++i) {
            ExponentialSum g = someCurvedWave(chance);
            if (chance.oneIn(2)) g.impulse();  // known from before, or not
            const double rate = chance.oneIn(2) ? rates.primary : rates.elastic;
            auto& response = basis.respond(g, rate, chance.fraction());
            QVERIFY(!basis.failed());
            const double length = chance.oneIn(2) ? g.length : g.length * chance.fraction();
            basis.endAt(response, length);
            const double rounding = 4e-15 * (1 + g.length);
            const auto isRight = [&](const ExponentialSum& f) {
                return std::abs(f.impulse() - f.integral(f.length)) < rounding;
            };
            ExponentialSum reflected;
            basis.reflect(response, reflected);
            reflected.shorten(length);
            QVERIFY(!std::isnan(reflected.curve.impulse) && isRight(reflected));
            reflected.shorten(length / 2);
            QVERIFY(isRight(reflected));
            if (length == g.length) continue;
            basis.dropFront(g, response);
            QVERIFY(isRight(g));
            g.dropFront(g.length / 2);
            QVERIFY(isRight(g));
        }
    }

    void aHammerThatIsAddedIsInTheImpulse() {
        ExponentialBasis basis;
        basis.begin(problemOf(Scene{PulseShape::trapezoid, {rates.primary, 0.14, 10, 0}}), rates);
        Chance chance(12);
        ExponentialSum g = someCurvedWave(chance);
        const double before = g.impulse();
        basis.addHammer({.kind = PulseSegment::Kind::linear, .value = 2}, 0, g.length, g);
        QVERIFY(std::abs(g.impulse() - before - 2 * g.length) < 1e-14 * (1 + g.length));
    }
};

QTEST_GUILESS_MAIN(TestExponentialBasis)
#include "tst_exponential_basis.moc"
