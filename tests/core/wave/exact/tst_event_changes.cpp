// SPDX-License-Identifier: GPL-3.0-or-later
// Where an event appears or vanishes, or falls on the arrival of a front, e is right on either side.
#include <QTest>

#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/exact/input_move.h"
#include "core/wave/exact/series_basis.h"
#include "tests/support/basis_scenes.h"
#include "tests/support/event_change.h"
#include "tests/support/network_scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr int fewChanges = 160;

/// Some for every run of the tests. DRILLWAVE_EVENT_CHANGES=4000 takes minutes.
int changesToFind() {
    return tries("DRILLWAVE_EVENT_CHANGES", fewChanges);
}

/// Sums that were made apart, of right blows: rounding of joined pieces, 4e-10 at most.
constexpr double balanced = 1e-9;

std::string words(const Scene& scene, const Impact& impact, const Impact& truth) {
    return describe(scene) + ": e " + formatNumber(impact.cor) + " +- " + formatNumber(impact.corError) +
           ", long double " + formatNumber(truth.cor) + " +- " + formatNumber(truth.corError) +
           ", energy residual " + formatNumber(impact.energyResidual());
}

/// Findings about the neighbours of a change.
struct Tally {
    int changes = 0, blows = 0, notSolved = 0, wrong = 0, wrongOfGrowth = 0, unbalanced = 0;
    std::string worst;
};

class Study {
  public:
    void look(const EventChange& change, Tally& tally) {
        constexpr int neighboursOnEachSide = 8;
        ++tally.changes;
        for (const Scene& scene : change.neighbours(neighboursOnEachSide)) {
            ++tally.blows;
            const Problem problem = problemOf(scene);
            const Impact impact = m_solver.solve(problem, Detail::ledger);
            const Impact alone = m_solver.solve(problem, Detail::cor);
            const Impact truth = solveInExtendedPrecision(problem, Detail::cor);
            const auto blame = [&](int& count) {
                if (count++ == 0) tally.worst = words(scene, impact, truth) + " " + impact.reason.text();
            };
            if (impact.outcome != Outcome::rebounded || alone.outcome != Outcome::rebounded ||
                truth.outcome != Outcome::rebounded) {
                blame(tally.notSolved);
                continue;
            }
            if (std::abs(impact.energyResidual()) > balanced) blame(tally.unbalanced);
            const bool isRight = agree(impact, truth) && agree(alone, truth);
            if (!isRight) blame(impact.growth > coveredGrowth ? tally.wrongOfGrowth : tally.wrong);
        }
    }

  private:
    static bool agree(const Impact& impact, const Impact& truth) {
        return std::abs(impact.cor - truth.cor) <= impact.corError + truth.corError;
    }
    ExactSolver m_solver;
};

const Scene raisedByAFront{PulseShape::exponential, {4.98325, 0.680524, 0.63574, 0.5803234527990637}};

/// Takes every force on the unloading line for one that has just turned: some then reach the primary line
/// from above.
struct MistakenBasis : SeriesBasis<double> {
    Zero<double> forceReaches(const Response& r, double peak, bool) {
        return SeriesBasis<double>::forceReaches(r, peak, true);
    }
};

}  // namespace

class TestEventChanges : public QObject {
    Q_OBJECT

  private slots:
    void aForceThatTurnsAsAFrontArrivesIsRaisedByIt_data() {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<double>("e");
        const auto row = [](const char* name, PulseShape shape, Groups groups, double e) {
            QTest::newRow(name) << Scene{shape, groups} << e;
        };
        row("gap", raisedByAFront.shape, raisedByAFront.groups, 0.717216);
        row("small gamma", PulseShape::exponential, {1.10626, 0.1, 0.35849, 0.43879244594666483}, 0.171773);
        row("short rod", PulseShape::exponential, {4.2106, 0.665556, 0.282805, 0.111163186073214}, 0.123030);
    }

    /// The force turns at its maximum, and just then the front of a returning wave raises it again.
    void aForceThatTurnsAsAFrontArrivesIsRaisedByIt() {
        QFETCH(Scene, scene);
        QFETCH(double, e);
        ExactSolver solver;
        for (const Detail detail : {Detail::cor, Detail::summary, Detail::ledger}) {
            const Impact impact = solver.solve(problemOf(scene), detail);
            QCOMPARE(impact.outcome, Outcome::rebounded);
            QVERIFY2(std::abs(impact.cor - e) < 1e-6, formatNumber(impact.cor).c_str());
        }
    }

    void anExactTurnAtTheFrontIsNone() {
        // F = 4(e^{−s} − e^{−2s}) turns at s = ln 2, and the first front is back at 2τ
        Scene scene{PulseShape::exponential, {2, 0.05, std::log(2.0) / 2, 0}};
        for (const double tau :
             {std::nextafter(scene.groups.tau, 0), scene.groups.tau, std::nextafter(scene.groups.tau, 1)}) {
            scene.groups.tau = tau;
            const Problem problem = problemOf(scene);
            const Impact impact = ExactSolver().solve(problem, Detail::ledger);
            const Impact truth = solveInExtendedPrecision(problem, Detail::cor);
            QVERIFY2(std::abs(impact.cor - truth.cor) <= impact.corError,
                     words(scene, impact, truth).c_str());
        }
    }

    void whatLosesEnergyIsNoResult() {
        const Problem problem = problemOf(raisedByAFront);
        const auto solve = [&problem](auto basis) {
            ContactMarch<decltype(basis)> march;
            Impact impact;
            march.solve(problem, Detail::ledger, impact);
            return impact;
        };
        const Impact right = solve(SeriesBasis<double>());
        QCOMPARE(right.outcome, Outcome::rebounded);
        QVERIFY(std::abs(right.energyResidual()) < balanced);
        const Impact wrong = solve(MistakenBasis());
        QVERIFY(std::abs(wrong.energyResidual()) > 1e-3);
        QCOMPARE(wrong.outcome, Outcome::notSolved);
        QVERIFY(wrong.reason.text().find("energies") != std::string::npos);
    }

    void onEitherSideOfAChangeOfEventsNothingIsWrong_data() {
        QTest::addColumn<PulseShape>("shape");
        for (int shape = 0; shape < 8; ++shape)
            QTest::newRow(name(PulseShape(shape)).data()) << PulseShape(shape);
    }

    void onEitherSideOfAChangeOfEventsNothingIsWrong() {
        QFETCH(PulseShape, shape);
        BasisScenes scenes(11, shape);
        EventChanges changes;
        Study study;
        Tally tally;
        const int wanted = changesToFind() / 8;
        unsigned tried = 0;
        for (; tally.changes < wanted && tried < 100U * unsigned(wanted); ++tried) {
            Chance chance(tried);
            if (const auto change = changes.find(scenes.scene(tried), chance)) study.look(*change, tally);
        }
        QCOMPARE(tally.changes, wanted);
        if (changesToFind() > fewChanges)
            std::printf(
                "%s: %d changes, %d blows, %d wrong, %d wrong of growth, %d unbalanced, %d not solved\n",
                QTest::currentDataTag(), tally.changes, tally.blows, tally.wrong, tally.wrongOfGrowth,
                tally.unbalanced, tally.notSolved);
        const int bad = tally.wrong + tally.unbalanced + tally.notSolved;
        QVERIFY2(bad == 0, tally.worst.c_str());
        QVERIFY2(tally.wrongOfGrowth <= 1 + tally.blows / 1000, tally.worst.c_str());
    }

    /// The node of the bit goes its own way along the law.
    void norIsItWhereTheRodIsAString() {
        EventChanges changes;
        NetworkSolver solver;
        const int wanted = changesToFind() / 8;
        int found = 0;
        for (unsigned tried = 0; found < wanted && tried < 100U * unsigned(wanted); ++tried) {
            Chance chance(tried);
            Scene scene;  // of a transit time that shares a cell with the hammer
            scene.groups = {chance.logarithmic(0.3, 60), chance.logarithmic(0.05, 1),
                            0.25 * (2 + chance.below(6)), chance.oneIn(3) ? 0 : 1.5 * chance.fraction()};
            const auto change = changes.find(scene, chance);
            if (!change || change->group == &Groups::tau) continue;
            ++found;
            for (const Scene& neighbour : change->neighbours(3)) {
                const Impact truth = solveInExtendedPrecision(problemOf(neighbour), Detail::cor);
                Problem rod = rodAsString(neighbour.groups, 0);
                rod.endTime.reset();
                for (const auto accuracy : {NetworkAccuracy::quick, NetworkAccuracy::sure}) {
                    const Impact impact = solver.solve(rod, {.accuracy = accuracy, .wants = {}});
                    QCOMPARE(impact.outcome, Outcome::rebounded);
                    const double e = -impact.finalMomentum / impact.faceImpulse;
                    QVERIFY2(std::abs(e - truth.cor) <= impact.corError + truth.corError,
                             (describe(neighbour) + ": e " + formatNumber(e)).c_str());
                }
            }
        }
        QCOMPARE(found, wanted);
    }
};

QTEST_GUILESS_MAIN(TestEventChanges)
#include "tst_event_changes.moc"
