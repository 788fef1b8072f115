// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's analytical solution (theory §5), and where it holds.
#include <QTest>

#include "core/wave/closed/closed_form.h"
#include "core/wave/field/bit_history.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Simpson's rule.
template <class Function>
double integral(Function f, double from, double to, int halves = 2000) {
    const double h = (to - from) / (2 * halves);
    double sum = f(from) + f(to);
    for (int i = 1; i < 2 * halves; ++i) sum += (i % 2 ? 4 : 2) * f(from + i * h);
    return sum * h / 3;
}

Impact closedForm(const Groups& groups, Detail detail = Detail::cor) {
    return solveClosedForm(problemOf(pulseForceOf(PulseShape::rectangular), groups), detail);
}

const std::vector<double> stiffnesses{0.01, 0.1, 0.3, 0.5, 1, 1.2564312, 1.2564313, 2, 10, 300};

}  // namespace

class TestClosedForm : public QObject {
    Q_OBJECT

  private slots:
    void publishedValuesAreMet() {
        // theory §7: [paper (15)] at β = 0.5; and the limit of a soft rock, 4e^(−1/2) − 1
        QVERIFY(std::abs(closedFormRestitution(0.5) - 1.4011370) < 5e-8);
        QVERIFY(std::abs(closedFormRestitution(1e-12) - (4 * std::exp(-0.5) - 1)) < 1e-11);
        QVERIFY(std::abs(closedFormRestitution(1e12) - 1) < 1e-11);
        // β1 joins two formulas
        const double root = 1.25643120862617;
        QVERIFY(std::abs(std::exp(root) - 2 * root - 1) < 1e-13);
        QVERIFY(std::abs(closedFormRestitution(root - 1e-9) - closedFormRestitution(root + 1e-9)) < 1e-8);
    }

    void pulsesSatisfyTheContactEquation() {
        // F' = β (2g − F) with g = 1 over [0, 1), then g = g − F1 of the wave that comes back
        for (const double beta : stiffnesses) {
            const double h = 1e-5 / (1 + beta);
            const double end = std::min(secondPulseEnd(beta), 30.0);
            for (const double t : {0.1, 0.4, 0.9, 1.2, 2.5, 7.0}) {
                const auto residual = [&](auto force, double g) {
                    const double change = (force(beta, t + h) - force(beta, t - h)) / (2 * h);
                    return std::abs(change - beta * (2 * g - force(beta, t))) / (1 + beta);
                };
                const double wave = t < 1 ? 1 : 0;
                // rounding of the difference quotient
                QVERIFY(residual(firstForcePulse, wave) < 1e-9);
                if (t + h < end) QVERIFY(residual(secondForcePulse, wave - firstForcePulse(beta, t)) < 1e-9);
            }
        }
    }

    void impulsesAreTheIntegralsOfThePulses() {
        for (const double beta : stiffnesses) {
            const auto first = [&](double t) { return firstForcePulse(beta, t); };
            const auto second = [&](double t) { return secondForcePulse(beta, t); };
            const double end = secondPulseEnd(beta);
            const double corner = std::min(end, 1.0);
            // Simpson on layers of width 1/β
            const int halves = 20000;
            const double beyond = 1 + 40 / beta;
            QVERIFY(std::abs(integral(first, 0, 1 - 1e-15, halves) + integral(first, 1, beyond, halves) - 2) <
                    1e-9);
            double found = integral(second, 0, corner - 1e-15, halves);
            if (end > 1) found += integral(second, 1, end - 1e-12, halves);
            QVERIFY2(std::abs(found - secondPulseImpulse(beta)) < 1e-9, qPrintable(QString::number(beta)));
            QVERIFY(std::abs(second(end * (1 - 1e-9))) < 1e-6 && second(end) == 0);
        }
    }

    void theNeglectedOverlapBoundsTheError() {
        ExactSolver exact;
        int checked = 0, overlapping = 0;
        for (double tau = 0.5; tau < 60; tau *= 1.4)
            for (double beta = 1e-3; beta < 1e5; beta *= 1.6) {
                const Groups groups{beta, 1, tau, 0};
                const Impact found = closedForm(groups);
                if (found.outcome != Outcome::rebounded) {
                    ++overlapping;
                    continue;
                }
                ++checked;
                const Impact expected = exact.solve(problemOf(pulseForceOf(PulseShape::rectangular), groups));
                const double excess = found.cor - expected.cor;
                const double rounding = 1e-14 + expected.corError;
                QVERIFY(excess >= -rounding && excess <= found.corError + rounding);
                // and it is no exaggeration: at least 3/4 of it, where it can be seen
                if (found.corError > 1e-9) QVERIFY(excess > 0.75 * found.corError);
            }
        QVERIFY(checked > 200 && overlapping > 50);
    }

    void historiesAreThoseOfTheExactSolutionButForTheOverlap_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("paper Fig. 5") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0}};
        QTest::newRow("second pulse within its wave") << Scene{PulseShape::rectangular, {3, 1, 5, 0}};
        QTest::newRow("one period later") << Scene{PulseShape::rectangular, {0.8, 1, 10, 1}};
        QTest::newRow("seven periods later") << Scene{PulseShape::rectangular, {0.8, 1, 10, 7}};
        QTest::newRow("pulse of a whole round trip") << Scene{PulseShape::rectangular, {50, 1, 0.5, 0}};
    }

    void historiesAreThoseOfTheExactSolutionButForTheOverlap() {
        QFETCH(Scene, scene);
        const Groups& g = scene.groups;
        const Impact found = closedForm(g, Detail::histories);
        const Impact expected = solve(scene, Detail::histories);
        QCOMPARE(found.contacts, expected.contacts);
        QCOMPARE(found.events.size(), expected.events.size());
        for (std::size_t i = 0; i < found.events.size(); ++i)
            QVERIFY(std::abs(found.events[i].time - expected.events[i].time) <
                    1e-9 + 10 * firstForcePulse(g.beta, 2 * g.tau));
        const double overlap = firstForcePulse(g.beta, 2 * g.tau);  // which is cut off
        for (double t = 0.003; t < expected.separationTime + 3 * g.tau; t += 0.0617) {
            const double s = t - g.tau;
            QVERIFY(std::abs(impactForce(found, s) - impactForce(expected, s)) <= 1.01 * overlap + 1e-12);
            QVERIFY(std::abs(incidentWave(found, s) - incidentWave(expected, s)) <= 2 * overlap + 1e-12);
        }
        QVERIFY(std::abs(found.peakForce - expected.peakForce) <= overlap + 1e-14);
        QVERIFY(std::abs(1 - found.impulse - found.finalMomentum) < 4 * overlap / g.beta + 1e-13);
        QVERIFY(std::abs(found.rockWork + found.finalEnergy - found.hammerWork) <
                4 * overlap / g.beta + 1e-13);
        QCOMPARE(closedForm(g, Detail::cor).cor, found.cor);
    }

    void otherBlowsAreRefused_data() {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<QString>("named");
        QTest::newRow("inelastic rock") << Scene{PulseShape::rectangular, {0.5, 0.9, 10, 0}} << "gamma = 0.9";
        QTest::newRow("gap within the period")
            << Scene{PulseShape::rectangular, {0.5, 1, 10, 0.25}} << "delta = 0.25";
        QTest::newRow("another pulse") << Scene{PulseShape::triangular, {0.5, 1, 10, 0}} << "triangular";
        QTest::newRow("pulse longer than a round trip")
            << Scene{PulseShape::rectangular, {5, 1, 0.4, 0}} << "tau = 0.4";
        QTest::newRow("everything at once") << Scene{PulseShape::halfSine, {0.5, 0.5, 0.1, 0.5}}
                                            << "pulse.shape = half_sine, gamma = 0.5, delta = 0.5, tau = 0.1";
        QTest::newRow("reflections that overlap")
            << Scene{PulseShape::rectangular, {0.01, 1, 10, 0}} << "reflections overlap";
    }

    void otherBlowsAreRefused() {
        QFETCH(Scene, scene);
        QFETCH(QString, named);
        const Impact impact = solveClosedForm(problemOf(scene));
        QCOMPARE(impact.outcome, Outcome::notSolved);
        QVERIFY2(QString::fromStdString(impact.reason.text()).contains(named), impact.reason.text().c_str());
    }
};

QTEST_GUILESS_MAIN(TestClosedForm)
#include "tst_closed_form.moc"
