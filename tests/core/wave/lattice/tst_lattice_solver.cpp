// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's algorithm as a second solver: its order, its two variants, its estimate, its refusals.
#include <QTest>

#include "core/wave/lattice/lattice_solver.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr LatticeOptions withoutEstimate(int segments, LatticeWaves waves = LatticeWaves::ring) {
    return {.segments = segments, .waves = waves, .estimate = ErrorEstimate::none};
}

Impact solveLattice(const Scene& scene, const LatticeOptions& options, Detail detail = Detail::ledger) {
    LatticeSolver solver;
    return solver.solve(problemOf(scene), detail, options);
}

/// Error in e at N segments.
double errorOf(const Scene& scene, int segments, double cor) {
    return std::abs(solveLattice(scene, withoutEstimate(segments), Detail::cor).cor - cor);
}

/// Largest impact of scenes the lattice can be asked for: its steps must be shorter than the layers.
constexpr Domain resolvable{0.02, 20, 0.02, 0.2, 20, 3};

bool sameHistory(const PiecewisePolynomial& a, const PiecewisePolynomial& b) {
    if (a.pieces().size() != b.pieces().size()) return false;
    for (std::size_t i = 0; i < a.pieces().size(); ++i) {
        const auto &p = a.pieces()[i], &q = b.pieces()[i];
        if (p.start != q.start || p.length != q.length || a.value(p, 0) != b.value(q, 0)) return false;
    }
    return true;
}

}  // namespace

class TestLatticeSolver : public QObject {
    Q_OBJECT

  private slots:
    void anElasticRockGivesTheErrorsOfTheDevelopersTable_data() {
        QTest::addColumn<int>("segments");
        QTest::addColumn<double>("error");
        // theory §6, β = 0.5, τ = 10, δ = 0, γ = 1
        QTest::newRow("1 000") << 1000 << 1.1e-7;
        QTest::newRow("10 000, the paper's choice") << 10000 << 1.0e-9;
        QTest::newRow("20 000, its accurate choice") << 20000 << 2.5e-10;
    }

    void anElasticRockGivesTheErrorsOfTheDevelopersTable() {
        QFETCH(int, segments);
        QFETCH(double, error);
        const double found =
            errorOf({PulseShape::rectangular, {0.5, 1, 10, 0}}, segments, 1.4010824845070556);
        QVERIFY2(found > error / 3 && found < error * 3, qPrintable(QString::number(found)));
    }

    void theErrorFallsWithTheSquareOfTheStep_data() {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<double>("cor");
        // 33-digit solutions; steps that divide the pulse
        QTest::newRow("elastic") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0}} << 1.4010824845070556;
        QTest::newRow("bilinear") << Scene{PulseShape::rectangular, {0.5, 0.1, 10, 0}} << 0.4067107438747897;
        QTest::newRow("gap") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0.521}} << 0.84210576467383562;
    }

    void theErrorFallsWithTheSquareOfTheStep() {
        QFETCH(Scene, scene);
        QFETCH(double, cor);
        // corners of the law fall anywhere in a step: the mean over neighbours shows the order
        const auto meanError = [&](int segments) {
            double sum = 0;
            for (int i = -5; i <= 5; ++i) sum += errorOf(scene, segments + 10 * i, cor);
            return sum / 11;
        };
        const double order = std::log(meanError(1000) / meanError(8000)) / std::log(8);
        QVERIFY2(std::abs(order - 2) < 0.15, qPrintable(QString::number(order)));
    }

    void movedWavesAndRingGiveTheSameNumbers_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("paper Fig. 4 (a)") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0}};
        QTest::newRow("bilinear, pulse of 36.4 steps") << Scene{PulseShape::rectangular, {0.5, 0.1, 11, 0}};
        QTest::newRow("several contacts") << Scene{PulseShape::rectangular, {0.05, 0.05, 3.3, 0.9}};
        QTest::newRow("hammer longer than a round trip")
            << Scene{PulseShape::halfSine, {0.7, 0.3, 0.21, 0.4}};
        QTest::newRow("staircase of a piston") << Scene{PulseShape::piston, {0.3, 0.2, 2.7, 1.3}, 3};
        QTest::newRow("exponential, stiff") << Scene{PulseShape::exponential, {5, 0.5, 4.1, 7.7}};
        QTest::newRow("reference case") << Scene{PulseShape::rigidBody, {0.5, 0.1, 2, 0}};
    }

    void movedWavesAndRingGiveTheSameNumbers() {
        QFETCH(Scene, scene);
        const Impact moved =
            solveLattice(scene, withoutEstimate(400, LatticeWaves::moved), Detail::histories);
        const Impact ring = solveLattice(scene, withoutEstimate(400), Detail::histories);
        QCOMPARE(moved.outcome, Outcome::rebounded);
        // to the last bit, so without tolerance
        QVERIFY(moved.cor == ring.cor && moved.impulse == ring.impulse && moved.peakForce == ring.peakForce);
        QVERIFY(moved.finalMomentum == ring.finalMomentum && moved.finalEnergy == ring.finalEnergy);
        QVERIFY(moved.rockWork == ring.rockWork && moved.hammerWork == ring.hammerWork);
        QVERIFY(moved.events == ring.events && moved.pieces == ring.pieces && moved.skips == ring.skips);
        QVERIFY(sameHistory(moved.force, ring.force) && sameHistory(moved.incident, ring.incident));
    }

    void agreesWithTheExactSolutionWithinItsOwnEstimate() {
        RandomScenes scenes(resolvable, 20);
        LatticeSolver lattice;
        ExactSolver exact;
        std::vector<double> tightness;
        int contacts = 0, inelastic = 0;
        const auto solveFinely = [&](const Scene& scene) {
            return lattice.solve(problemOf(scene), Detail::cor, {.segments = 4000});
        };
        scenes.forEachSolved(250, solveFinely, [&](const Scene& scene, const Impact& found) {
            const Impact expected = exact.solve(problemOf(scene), Detail::cor);
            const double error = std::abs(found.cor - expected.cor);
            QVERIFY2(error <= found.corError + expected.corError, describe(scene).c_str());
            tightness.push_back(error / found.corError);
            contacts += expected.contacts > 1;
            inelastic += scene.groups.gamma < 1;
        });
        QVERIFY(contacts > 40 && inelastic > 100);
        // and the estimate is not just large
        std::ranges::sort(tightness);
        QVERIFY2(tightness[tightness.size() / 2] > 0.02,
                 qPrintable(QString::number(tightness[tightness.size() / 2])));
    }

    void agreesWithTheReferenceCases() {
        LatticeSolver lattice;
        int solved = 0;
        for (const ReferenceCase& expected : referenceCases()) {
            const Impact found = lattice.solve(problemOf(expected.scene), Detail::ledger, {.segments = 2000});
            if (found.outcome != Outcome::rebounded) continue;
            ++solved;
            const std::string where = describe(expected.scene);
            QVERIFY2(std::abs(found.cor - expected.cor) <= found.corError, where.c_str());
            // what the force changes by in a step, β (2g − F) Δ, of which a jump of g may miss a part
            const Groups& g = expected.scene.groups;
            const double tolerance = g.beta * g.tau / 2000 * std::max(1.0, expected.peakForce) + 1e-12;
            QVERIFY2(std::abs(found.peakForce - expected.peakForce) <= tolerance, where.c_str());
        }
        QVERIFY2(solved > 70, qPrintable(QString::number(solved)));
    }

    void momentumAndEnergyAreKeptWhateverTheStep() {
        RandomScenes scenes(resolvable, 21);
        int segments = 1000;
        const auto solveWithOneMore = [&](const Scene& scene) {
            return solveLattice(scene, withoutEstimate(++segments));
        };
        scenes.forEachSolved(150, solveWithOneMore, [](const Scene& scene, const Impact& impact) {
            // the lattice is a conservative system of its own: only rounding
            QVERIFY2(std::abs(1 - impact.impulse - impact.finalMomentum) < 1e-12, describe(scene).c_str());
            QVERIFY2(std::abs(impact.rockWork + impact.finalEnergy - impact.hammerWork) <
                         1e-12 * std::max(1.0, impact.hammerWork),
                     describe(scene).c_str());
            if (scene.groups.gamma == 1) QVERIFY2(std::abs(impact.rockWork) < 1e-12, describe(scene).c_str());
            QVERIFY(impact.rockWork > -1e-12 && impact.peakForce > 0);
        });
    }

    void aPulseOfHalfARoundTripIsTheReferenceCase() {
        // equal-work identity, τ = 1/2 and δ = 0: the same steps in the same order
        const Impact pulse =
            solveLattice({PulseShape::rectangular, {0.7, 0.2, 0.5, 0}}, withoutEstimate(500));
        const Impact body = solveLattice({PulseShape::rigidBody, {0.7, 0.2, 0.5, 0}}, withoutEstimate(500));
        QVERIFY(pulse.cor == body.cor && pulse.peakForce == body.peakForce && pulse.pieces == body.pieces);
    }

    void driftOfManyPeriodsIsSkipped() {
        // two contacts, then six periods towards the third
        const Scene scene{PulseShape::triangular,
                          {8.608803593025662, 0.001445050398879033, 0.10597910724628155, 0}};
        const Impact found = solveLattice(scene, {.segments = 4000}, Detail::histories);
        const Impact expected = solve(scene, Detail::histories);
        QCOMPARE(found.outcome, Outcome::rebounded);
        QCOMPARE(found.skips.size(), std::size_t(1));
        QVERIFY(std::abs(found.skips[0].duration / found.roundTrip - 6) < 1e-9);
        QCOMPARE(found.contacts, expected.contacts);
        QVERIFY(std::abs(found.cor - expected.cor) <= found.corError);
        QVERIFY(std::abs(found.separationTime - expected.separationTime) < 1e-5);
    }

    void aHugeGapTakesNoMoreStepsThanASmallOne() {
        const Impact far =
            solveLattice({PulseShape::rectangular, {0.5, 0.1, 10, 1e6 + 0.5}}, withoutEstimate(1000));
        const Impact near =
            solveLattice({PulseShape::rectangular, {0.5, 0.1, 10, 0.5}}, withoutEstimate(1000));
        QVERIFY(far.pieces < near.pieces + 10000);
        // the gap loses 1e6 times rounding
        QVERIFY(std::abs(far.cor - near.cor) < 1e-9);
        QVERIFY(std::abs(far.separationTime - near.separationTime - 1e6 * 20) < 1e-6);
    }

    void eventsAreThoseOfTheExactSolution() {
        const Scene scene{PulseShape::rectangular, {0.05, 0.05, 3.3, 0.9}};
        const Impact found = solveLattice(scene, withoutEstimate(20000));
        const Impact expected = solve(scene, Detail::ledger);
        QCOMPARE(found.contacts, expected.contacts);
        QCOMPARE(found.events.size(), expected.events.size());
        for (std::size_t i = 0; i < found.events.size(); ++i) {
            QCOMPARE(found.events[i].kind, expected.events[i].kind);
            // a step is 1.7e-4
            QVERIFY(std::abs(found.events[i].time - expected.events[i].time) < 2e-4);
        }
    }

    void whatTheStepsCannotResolveIsNotSolved_data() {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<int>("segments");
        QTest::addColumn<QString>("reason");
        QTest::newRow("unloading faster than a step")
            << Scene{PulseShape::rectangular, {10, 0.01, 10, 0}} << 1000 << "too long for the rock";
        QTest::newRow("stiff elastic rock")
            << Scene{PulseShape::rectangular, {1e9, 1, 10, 0}} << 1000000 << "at least 5e+09 segments";
        QTest::newRow("contact shorter than a step")
            << Scene{PulseShape::rectangular, {0.05, 0.05, 20, 0.99}} << 20 << "shorter than a step";
        QTest::newRow("very long pulse on a very short rod")
            << Scene{PulseShape::exponential, {0.5, 1, 1e-6, 0}} << 10000 << "number of steps";
    }

    void whatTheStepsCannotResolveIsNotSolved() {
        QFETCH(Scene, scene);
        QFETCH(int, segments);
        QFETCH(QString, reason);
        const Impact impact = solveLattice(scene, {.segments = segments});
        QCOMPARE(impact.outcome, Outcome::notSolved);
        QVERIFY2(QString::fromStdString(impact.reason.text()).contains(reason), impact.reason.text().c_str());
    }

    void aLongSolveStopsAtOnce() {
        for (const LatticeWaves waves : {LatticeWaves::moved, LatticeWaves::ring}) {
            std::stop_source source;
            source.request_stop();
            // 1e5 round trips in contact: 2e8 steps
            const Scene scene{PulseShape::rectangular, {1e-10, 1, 10, 0}};
            LatticeSolver solver;
            const Impact impact = solver.solve(problemOf(scene), Detail::cor,
                                               {.segments = 1000, .waves = waves}, source.get_token());
            QCOMPARE(impact.outcome, Outcome::notSolved);
            QCOMPARE(impact.reason.text(), std::string("stopped"));
            // a million steps of a ring take milliseconds, and each of them moves a thousand waves and more
            const long mostSteps = waves == LatticeWaves::ring ? 1'000'000 + 100'000 : 1'100;
            QVERIFY2(impact.pieces <= mostSteps, std::to_string(impact.pieces).c_str());
        }
    }
};

QTEST_GUILESS_MAIN(TestLatticeSolver)
#include "tst_lattice_solver.moc"
