// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of waves that are not kept, against those of waves that are.
#include <QTest>

#include "core/blow/blow.h"
#include "core/blow/impact_summary.h"
#include "core/blow/outputs.h"
#include "core/study/rows/case_solver.h"
#include "core/wave/exact/exact_solver.h"

using namespace drillwave;

namespace {

/// A blow of a piston on a short rod, of some 600 000 pieces and 79 contacts.
Scenario longBlow() {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = {1, 0.07, 0.05, 0};
    scenario.pulse.shape = PulseShape::piston;
    scenario.pulse.piston.impedanceRatio = 19;
    return scenario;
}

}  // namespace

class TestWaveNumbers : public QObject {
    Q_OBJECT

  private slots:
    /// The histories of a whole blow used to be kept for its largest stresses and peaks: 0.9 GB.
    void aSummaryKeepsNoLongHistories() {
        const Blow kept = solveBlow(longBlow(), {}, Detail::histories, {}, Stresses::wanted);
        QVERIFY(kept.impact.pieces > mostPiecesKept && kept.impact.hasHistories());
        const Blow passed = solveBlow(longBlow(), {}, Detail::ledger, {}, Stresses::wanted);
        QVERIFY(!passed.impact.hasHistories());
        QVERIFY(passed.isSolved() && passed.summary.rodForces);
        for (const auto force : {&RodForces::compression, &RodForces::tension, &RodForces::compressionAfter,
                                 &RodForces::tensionAfter}) {
            const RodForce passing = (*passed.summary.rodForces).*force;
            const RodForce whole = (*kept.summary.rodForces).*force;
            QCOMPARE(passing.size, whole.size);
            // each part begins at a time that is rounded
            const double rounding = 1e-12 * kept.impact.separationTime;
            QVERIFY2(std::abs(passing.time - whole.time) <= rounding,
                     QByteArray::number(passing.time - whole.time));
            QVERIFY2(std::abs(passing.section - whole.section) * kept.impact.roundTrip <= rounding,
                     QByteArray::number(passing.section - whole.section));
        }
        QCOMPARE(*passed.summary.forcePeaks, *kept.summary.forcePeaks);
        QCOMPARE(passed.impact.pieces, kept.impact.pieces);
    }

    void aRowKeepsNoLongHistories() {
        const Blow kept = solveBlow(longBlow(), {}, Detail::histories, {}, Stresses::wanted);
        const std::vector<OutputColumn> columns{{findOutput("peak_tension")}, {findOutput("force_peaks")}};
        CaseSolver solver(columns, {}, 1'000'000);
        solver.setPulse(longBlow());
        std::vector<double> row(2);
        QVERIFY(solver.solve(longBlow(), row, {}).isEmpty());
        QVERIFY(!solver.impact().hasHistories());
        QCOMPARE(row[0], kept.summary.rodForces->tension.size);
        QCOMPARE(row[1], double(*kept.summary.forcePeaks));
    }

    void partsOfHistoriesStayShort() {
        const Problem problem = problemOf(longBlow());
        const Impact solved = ExactSolver().solve(problem, Detail::ledger);
        std::size_t parts = 0, longest = 0;
        const Impact rest = marchInPassing(problem, solved.pieces,
                                           [&](Impact& recording) {
                                               ++parts;
                                               longest =
                                                   std::max(longest, recording.incident.pieces().size());
                                               recording.incident.clear(recording.incident.end());
                                               recording.force.clear(recording.force.end());
                                               return piecesHandedOver;
                                           },
                                           {});
        QCOMPARE(rest.outcome, Outcome::rebounded);
        QVERIFY(parts > 20);
        QVERIFY(longest < piecesHandedOver + 100);
    }

    void aStopLeavesTheBlowUnsolved() {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!solveBlow(longBlow(), {}, Detail::ledger, stop.get_token(), Stresses::wanted).isSolved());
    }
};

QTEST_GUILESS_MAIN(TestWaveNumbers)
#include "tst_wave_numbers.moc"
