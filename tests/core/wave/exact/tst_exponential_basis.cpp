// SPDX-License-Identifier: GPL-3.0-or-later
// A stretch of contact in closed form: what it leaves of the waves that arrived.
#include "core/wave/exact/exponential_basis.h"

#include <QTest>
#include <cmath>

#include "tests/support/corner_scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

using Basis = ExponentialBasis<3>;
using Sum = Basis::Piece;

constexpr LineRates<3> rates{0.7, 5, 1.9};

Problem blowOnACorner(PulseShape shape) {
    return withCorners(problemOf(Scene{shape, {rates[0], rates[0] / rates[1], 10, 0}}),
                       {{0.5, rates[2] / rates[0]}});
}

/// A ramp, a sine or both, and up to three decays of each rate.
Sum someCurvedWave(Chance& chance) {
    const auto some = [&] { return 2 * chance.fraction() - 1; };
    Sum g = Sum::zero(chance.logarithmic(0.01, 20));
    g.rates = &rates;
    g.c0 = some();
    for (Coefficients& decays : g.decays) {
        decays.count = static_cast<int>(chance.below(4));
        for (int m = 0; m < decays.count; ++m) decays.c[m] = some();
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
        Basis basis;
        const Problem problem = blowOnACorner(PulseShape::halfSine);
        basis.begin(problem, ContactLaw<double>(problem.law));
        Chance chance(11);
        for (int i = 0; i < 2000; ++i) {
            Sum g = someCurvedWave(chance);
            if (chance.oneIn(2)) g.impulse();  // known from before, or not
            const double rate = rates[chance.below(3)];
            auto& response = basis.respond(g, rate, chance.fraction());
            QVERIFY(!basis.failed());
            const double length = chance.oneIn(2) ? g.length : g.length * chance.fraction();
            basis.endAt(response, length);
            const double rounding = 4e-15 * (1 + g.length);
            const auto isRight = [&](const Sum& f) {
                return std::abs(f.impulse() - f.integral(f.length)) < rounding;
            };
            Sum reflected;
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
        Basis basis;
        const Problem problem = blowOnACorner(PulseShape::trapezoid);
        basis.begin(problem, ContactLaw<double>(problem.law));
        Chance chance(12);
        Sum g = someCurvedWave(chance);
        const double before = g.impulse();
        basis.addHammer({.kind = PulseSegment::Kind::linear, .value = 2}, 0, g.length, g);
        QVERIFY(std::abs(g.impulse() - before - 2 * g.length) < 1e-14 * (1 + g.length));
    }
};

QTEST_GUILESS_MAIN(TestExponentialBasis)
#include "tst_exponential_basis.moc"
