// SPDX-License-Identifier: GPL-3.0-or-later
// A force on the rear end of a string: against the exact solver, a plain lattice and the balances.
#include <QTest>
#include <numeric>

#include "core/wave/network/network_solver.h"
#include "core/wave/network/plain_lattice.h"
#include "tests/support/network_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

double cor(const Impact& impact) {
    return -impact.finalMomentum / impact.faceImpulse;
}

/// The same string with every section in two of the same impedance.
Problem halved(Problem problem) {
    std::vector<UniformSection> sections;
    for (UniformSection section : problem.sections) {
        UniformSection first = section;
        first.massAfter = first.loss = 0;
        first.transitTime = section.transitTime = section.transitTime / 2;
        first.decay = section.decay = section.decay / 2;
        sections.push_back(first);
        sections.push_back(section);
    }
    problem.sections = sections;
    return problem;
}

/// A few sections of all kinds under a force.
Problem randomForcedString(Chance& chance) {
    Problem problem = randomNetwork(chance);
    problem.sections.erase(problem.sections.begin(),
                           problem.sections.begin() + std::ptrdiff_t(problem.hammerSections()));
    constexpr std::array shapes{PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine,
                                PulseShape::exponential, PulseShape::trapezoid,  PulseShape::piston};
    const unsigned shape = chance.below(shapes.size() + 1);
    problem.drive = shape < shapes.size()
                        ? pulseForceOf(shapes[shape], chance.logarithmic(0.3, 5))
                        : pulseForceOf(TableShape{10 + int(chance.below(60)), chance.below(1000)});
    return problem;
}

}  // namespace

class TestForceDrive : public QObject {
    Q_OBJECT

  private slots:
    void stringOfOneSectionEqualsTheExactSolver_data() {
        addRodScenes();
        QTest::newRow("exponential") << Scene{PulseShape::exponential, {1.5, 0.4, 3.3, 0.1}};
        QTest::newRow("trapezoid") << Scene{PulseShape::trapezoid, {0.4, 0.2, 6.1, 0.2}};
        QTest::newRow("stiff rock") << Scene{PulseShape::triangular, {30, 0.3, 5, 0}};
        QTest::newRow("long rod of no whole number of t0")
            << Scene{PulseShape::rectangular, {0.5, 0.3, 7.123456, 0.3}};
        QTest::newRow("piston, no whole number of t0") << Scene{PulseShape::piston, {0.5, 0.3, 3.21, 0.1}};
        QTest::newRow("elastic piston") << Scene{PulseShape::piston, {1, 1, 4, 0.3}};
    }

    void stringOfOneSectionEqualsTheExactSolver() {
        QFETCH(Scene, scene);
        const Problem problem = problemOf(scene);
        if (problem.force().isRigidBody()) {
            QVERIFY(!networkRefusal(problem).empty());
            return;
        }
        const Impact exact = solve(scene, Detail::ledger);
        const Impact impact = solveNetwork(problem, {});
        QVERIFY2(impact.outcome == Outcome::rebounded, impact.reason.text().c_str());
        const auto agrees = [](const char* what, double value, double expected) {
            QVERIFY2(std::abs(value - expected) < 1e-9, QString("%1: %2, not %3")
                                                            .arg(what)
                                                            .arg(value, 0, 'g', 15)
                                                            .arg(expected, 0, 'g', 15)
                                                            .toUtf8());
        };
        agrees("cor", cor(impact), exact.cor);
        agrees("impulse", impact.impulse, exact.impulse);
        agrees("peak force", impact.peakForce, exact.peakForce);
        agrees("hammer work", impact.hammerWork, exact.hammerWork);
        agrees("rock work", impact.efficiency() * impact.hammerWork, exact.rockWork);
        agrees("first contact", impact.firstContactTime, exact.firstContactTime);
        agrees("last separation", impact.separationTime, exact.separationTime);
        QVERIFY(std::abs(impact.momentumResidual()) < 1e-11);
        QVERIFY(std::abs(cor(impact) - exact.cor) <= impact.corError);
    }

    void aMeasuredBlowOnOneSectionIsWithinItsStatedError() {
        for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
            if (!isChosen(int(seed), 5)) continue;
            const Groups groups{0.7, 0.2, 4 + 0.37 * seed, 0.1 * seed};
            const Problem problem = problemOf(pulseForceOf(TableShape{300, seed}), groups);
            const Impact exact = ExactSolver().solve(problem, Detail::ledger);
            const Impact impact = solveNetwork(problem, {});
            QVERIFY2(impact.outcome == Outcome::rebounded, impact.reason.text().c_str());
            const double off = std::abs(cor(impact) - exact.cor);
            QVERIFY2(off <= impact.corError && off < 1e-7,
                     QByteArray::number(off) + " of " + QByteArray::number(impact.corError));
            const double workOff = std::abs(impact.efficiency() - exact.rockWork / exact.hammerWork);
            QVERIFY(workOff <= impact.efficiencyError);
        }
    }

    /// The forces of a sure run took more work than is permitted, and the whole run was given up for them.
    void aMeasuredBlowOnAStringIsSureWithItsForces() {
        Problem problem = problemOf(pulseForceOf(TableShape{8, 3}), Groups{0.7, 0.1, 1.8, 0});
        const UniformSection rod = problem.sections.front();
        problem.sections.clear();
        for (int i = 0; i < 3; ++i) {
            problem.sections.push_back({.impedance = 1.9, .transitTime = 0.12, .loss = 0.02});
            problem.sections.push_back(rod);
            problem.sections.back().decay = 0.01;
        }
        problem.sections.push_back({.impedance = 3, .transitTime = 0.04, .massAfter = 0.05});
        NetworkSettings settings;
        const Impact sums = solveNetwork(problem, settings);
        settings.wants.forces = true;
        const Impact forces = solveNetwork(problem, settings);
        QVERIFY2(sums.efficiencyError < 1e-8, QByteArray::number(sums.efficiencyError));
        QVERIFY2(forces.efficiencyError < 1e-8, QByteArray::number(forces.efficiencyError));
        QCOMPARE(forces.sections.size(), problem.sections.size());
        QVERIFY(forces.sections.front().compression.force > 0);
    }

    void statedErrorsOfQuickRunsHoldOnRandomRods() {
        RandomScenes scenes({1e-2, 30, 0.05, 0.3, 30, 5}, 77);
        NetworkSolver solver;
        int compared = 0;
        const int rods = tries("DRILLWAVE_FORCED_RODS", 500);
        for (int i = 0; i < rods; ++i) {
            const Scene scene = scenes.nextQuick();
            const Problem problem = problemOf(scene);
            if (problem.force().isRigidBody()) continue;
            const Impact exact = solve(scene, Detail::ledger);
            const Impact impact = solver.solve(problem, {.accuracy = NetworkAccuracy::quick, .wants = {}});
            if (exact.outcome != Outcome::rebounded || impact.outcome == Outcome::notSolved) continue;
            ++compared;
            const double off = std::abs(cor(impact) - exact.cor);
            QVERIFY2(off <= impact.corError + exact.corError, describe(scene).c_str());
        }
        QVERIFY(compared > rods / 3 * 2);
    }

    void cuttingASectionInTwoChangesNothing() {
        Chance chance(11);
        for (int i = 0; i < 20; ++i) {
            const Problem problem = randomForcedString(chance);
            if (!isChosen(i, 5)) continue;
            const Impact whole = solveNetwork(problem, {}), cut = solveNetwork(halved(problem), {});
            QCOMPARE(whole.outcome, cut.outcome);
            if (whole.outcome == Outcome::notSolved) continue;
            const double off = std::abs(whole.efficiency() - cut.efficiency());
            QVERIFY2(off <= whole.efficiencyError + cut.efficiencyError,
                     QByteArray::number(i) + ": " + QByteArray::number(off));
        }
    }

    void momentumAndEnergyBalance() {
        Chance chance(12);
        int solved = 0, chosen = 0;
        for (int i = 0; i < 60; ++i) {
            const Problem problem = randomForcedString(chance);
            if (!isChosen(i, 5)) continue;
            ++chosen;
            const Impact impact = solveNetwork(problem, {});
            if (impact.outcome == Outcome::notSolved) continue;
            ++solved;
            QVERIFY2(std::abs(impact.momentumResidual()) < 1e-9,
                     QByteArray::number(i) + ": " + QByteArray::number(impact.momentumResidual()));
            QVERIFY2(std::abs(impact.energyResidual()) <= impact.efficiencyError, QByteArray::number(i));
            QVERIFY(impact.peakForce >= 0);
        }
        QVERIFY2(solved > chosen * 5 / 6, QByteArray::number(solved));
    }

    /// The lattice is of first order: two of them give the limit.
    void thePlainLatticeComesToTheSame() {
        Chance chance(13);
        int compared = 0, chosen = 0;
        for (int i = 0; i < 60; ++i) {
            Problem problem = randomForcedString(chance);
            if (!isChosen(i, 5)) continue;
            ++chosen;
            problem.endTime = std::max(*problem.endTime, problem.force().end);
            CellGrid grid;
            if (!usualGrid(problem, grid)) continue;
            while (grid.cell > 0.002) grid.halve();
            const Impact impact = solveNetwork(problem, {});
            if (impact.outcome == Outcome::notSolved) continue;
            const PlainBlow coarse = solvePlainLattice(problem, grid);
            grid.halve();
            const PlainBlow fine = solvePlainLattice(problem, grid);
            if (std::abs(coarse.efficiency - fine.efficiency) > 1e-3) continue;  // not where it leads yet
            ++compared;
            const double off = std::abs(fine.efficiency - impact.efficiency());
            QVERIFY2(off <= 4 * std::abs(coarse.efficiency - fine.efficiency) + 1e-4,
                     QByteArray::number(i) + ": " + QByteArray::number(off));
        }
        QVERIFY2(compared > chosen / 2, QByteArray::number(compared));
    }
};

QTEST_APPLESS_MAIN(TestForceDrive)
#include "tst_force_drive.moc"
