// SPDX-License-Identifier: GPL-3.0-or-later
// Rods so short that the hammer still pushes when reflections return: contacts follow closely, and both
// representations of the waves must find the same events.
#include <QTest>

#include "core/study/proof/equation_residuals.h"
#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/exponential_basis.h"
#include "core/wave/exact/exponential_domain.h"
#include "core/wave/exact/series_basis.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Scenes with τ 0.05 … 0.4 that the closed basis is tried for, every shape that it can take.
class ShortRods {
  public:
    Scene next() {
        for (;;) {
            static constexpr PulseShape shapes[] = {PulseShape::rectangular, PulseShape::triangular,
                                                    PulseShape::trapezoid, PulseShape::piston,
                                                    PulseShape::rigidBody};
            Scene scene;
            scene.shape = shapes[m_random() % 5];
            scene.impedanceRatio = logarithmic(0.3, 1.05);
            Groups& g = scene.groups;
            g.tau = logarithmic(0.05, 0.4);
            g.beta = logarithmic(1.5, 1e3) / g.tau;
            g.gamma = m_random() % 3 == 0 ? 1 : logarithmic(0.01, 0.7);
            g.delta = gap();
            if (scene.shape == PulseShape::rigidBody) g.delta = 0;
            if (suitsExponentials(problemOf(scene))) return scene;
        }
    }

  private:
    double gap() {
        switch (m_random() % 4) {
            case 0:
                return 0;
            case 1:
                return double(m_random() % 4);
            case 2:
                return 3 * fraction();
            default:
                return logarithmic(1e-14, 100);
        }
    }
    double fraction() { return static_cast<double>(m_random() >> 11) * 0x1p-53; }
    double logarithmic(double low, double high) { return low * std::pow(high / low, fraction()); }

    std::mt19937_64 m_random{11};
};

bool isSolved(const Impact& impact) {
    return impact.outcome == Outcome::rebounded;
}

}  // namespace

class TestShortRods : public QObject {
    Q_OBJECT

  private slots:
    void anEventIsNeverBeforeTheStartOfItsSearch() {
        // Halley's method stepped back out of its bracket: contact and separation on the spot, a wrong e in
        // the one scene and none in the other
        const Scene wrong{PulseShape::rectangular, {25.904579446675282, 0.1, 0.069132529248490504, 0}};
        const Scene none{PulseShape::rectangular, {38.852926094687284, 1, 0.085693142742192113, 0}};
        for (const Detail detail :
             {Detail::cor, Detail::summary, Detail::events, Detail::ledger, Detail::histories}) {
            QVERIFY(std::abs(solve(wrong, detail).cor - 0.0702006429485938) < 1e-13);
            QCOMPARE(solve(none, detail).outcome, Outcome::rebounded);
            QVERIFY(std::abs(solve(none, detail).cor - 0.0957256024683169) < 1e-13);
        }
    }

    void bothRepresentationsAgreeWithinTheirErrors() {
        ShortRods rods;
        ContactMarch<ExponentialBasis<2>> closedMarch;
        ContactMarch<SeriesBasis<double>> seriesMarch;
        ExactSolver solver;
        int inClosedForm = 0, otherContacts = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Scene scene = rods.next();
            const Problem problem = problemOf(scene);
            Impact closed, series;
            const bool ended =
                closedMarch.solve(problem, Detail::cor, closed, {.pieces = 2000}) && isSolved(closed);
            seriesMarch.solve(problem, Detail::cor, series);
            const Impact chosen = solver.solve(problem);
            QVERIFY2(!isSolved(series) || isSolved(chosen), describe(scene).c_str());
            QVERIFY2(std::abs(chosen.cor - series.cor) <= chosen.corError + series.corError,
                     describe(scene).c_str());
            if (!ended) continue;
            ++inClosedForm;
            otherContacts += closed.contacts != series.contacts;
            QVERIFY2(std::abs(closed.cor - series.cor) <= closed.corError + series.corError,
                     describe(scene).c_str());
        }
        QVERIFY2(inClosedForm > 10'000, std::to_string(inClosedForm).c_str());
        // a force of e^−43 may still lose its rock, or not: triangular pulses on rods so short graze often,
        // and more digits side with either
        QVERIFY2(otherContacts < 40, std::to_string(otherContacts).c_str());
    }

    void closedHistoriesSatisfyTheEquations() {
        ShortRods rods;
        ContactMarch<ExponentialBasis<2>> march;
        int checked = 0;
        for (int i = 0; i < 1000; ++i) {
            const Scene scene = rods.next();
            const Problem problem = problemOf(scene);
            Impact impact;
            if (!march.solve(problem, Detail::histories, impact, {.pieces = 2000})) continue;
            if (!isSolved(impact)) continue;
            ++checked;
            const EquationResiduals found = equationResiduals(impact, problem);
            // forces reach 1/(2τ) here; rounding in a few hundred pieces
            const double tolerance = 1e-12 / scene.groups.tau;
            QVERIFY2(found.wave < tolerance,
                     (describe(scene) + ": wave " + formatNumber(found.wave)).c_str());
            // a slope within a stretch of 1e-4 t0 has that many digits less; a wrong rate is off by its size
            QVERIFY2(found.rate < 1e4 * tolerance,
                     (describe(scene) + ": rate " + formatNumber(found.rate)).c_str());
            QVERIFY2(found.law < tolerance, (describe(scene) + ": law " + formatNumber(found.law)).c_str());
            QVERIFY2(found.leastForce > -tolerance, describe(scene).c_str());
            QVERIFY2(std::abs(impact.impulse - impact.force.integral(impact.force.end())) < tolerance,
                     describe(scene).c_str());
        }
        QVERIFY2(checked > 500, std::to_string(checked).c_str());
    }

    void whateverIsAskedForTheSameMarchDecides() {
        ShortRods rods;
        for (int i = 0; i < 500; ++i) {
            const Scene scene = rods.next();
            const Impact short_ = solve(scene, Detail::cor);
            const Impact summary = solve(scene, Detail::ledger);
            const Impact full = solve(scene, Detail::histories);
            QCOMPARE(summary.cor, short_.cor);
            QCOMPARE(full.cor, short_.cor);
            QCOMPARE(full.corError, short_.corError);
            QCOMPARE(summary.contacts, short_.contacts);
            QVERIFY(summary.events == full.events);
            const auto contacts = std::ranges::count(full.events, ContactEvent::contact, &ImpactEvent::kind);
            QCOMPARE(int(contacts), full.contacts);
        }
    }
};

QTEST_GUILESS_MAIN(TestShortRods)
#include "tst_short_rods.moc"
