// SPDX-License-Identifier: GPL-3.0-or-later
// The exact solver against reference cases, closed forms, identities, long double and the equations.
#include <QTest>

#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/series_basis.h"
#include "core/wave/exact/soft_reference.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// |a − b| ≤ tolerance, with both printed in full when not.
bool close(double a, double b, double tolerance) {
    if (std::abs(a - b) <= tolerance) return true;
    qWarning("%s",
             (formatNumber(a) + " is not " + formatNumber(b) + " to " + formatNumber(tolerance)).c_str());
    return false;
}

/// The closed form [paper (13)] [paper (15)], written independently: γ = 1, δ = 0, rectangular, no overlap.
double closedFormCor(double beta) {
    const double b1 = 1.25643120862616967698;  // e^x = 2x + 1
    if (beta > b1) {
        const double ts = b1 / beta;
        return 1 + 2 * (3 / beta * (1 - std::exp(-beta * ts)) - ts * (1 + 2 * std::exp(-beta * ts)));
    }
    const double ts = 1 / (1 - std::exp(-beta)) - 1 / (2 * beta);
    return 1 + 2 / beta *
                   (-beta - (3 + 2 * beta * ts) * std::exp(-beta * ts) +
                    (3 + 2 * beta * ts - 2 * beta) * std::exp(-beta * (ts - 1)));
}

/// Checks pointwise the conditions on the histories of an impact from any solver: the delay equation and the
/// contact law. Returns the largest violation.
double worstViolation(const Impact& impact, const PulseForce& pulse) {
    const auto pieces = impact.incident.pieces();
    const auto forces = impact.force.pieces();
    double worst = 0, peak = 0, previous = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const double part : {0.1, 0.5, 0.9}) {
            const double x = part * pieces[i].length;
            const double s = pieces[i].start + x;
            const double g = impact.incident.value(pieces[i], x);
            const double force = impact.force.value(forces[i], x);
            const double before = s - impact.roundTrip;
            double expected = pulse(s);
            if (before >= 0) expected += impact.incident(before) - impact.force(before);
            if (before < 0 && pulse.isRigidBody()) expected = 1 / impact.roundTrip;
            const double nearEdge = 1e-9 * (1 + s);  // a jump may fall to either side of it
            if (std::abs(pulse(s - nearEdge) - pulse(s + nearEdge)) < 1e-6 &&
                pieces[i].length > 10 * nearEdge)
                worst = std::max(worst, std::abs(g - expected));
            worst = std::max(worst, -force);
            peak = std::max(peak, force);
        }
        const double start = impact.force.value(forces[i], 0);
        worst = std::max(worst, std::abs(start - previous));  // F is continuous
        previous = impact.force.value(forces[i], pieces[i].length);
    }
    return worst;
}

}  // namespace

class TestExactSolver : public QObject {
    Q_OBJECT

  private slots:
    void agreesWithTheReferenceCases() {
        int row = 0;
        for (const ReferenceCase& expected : referenceCases()) {
            const Impact impact = solve(expected.scene, Detail::ledger);
            QCOMPARE(impact.outcome, Outcome::rebounded);
            const std::string where = "row " + std::to_string(++row) + ": " + describe(expected.scene);
            QVERIFY2(close(impact.cor, expected.cor, 2e-14), where.c_str());
            QVERIFY2(std::abs(impact.cor - expected.cor) <= impact.corError, where.c_str());
            QVERIFY2(close(impact.peakForce, expected.peakForce, 1e-12 * expected.peakForce), where.c_str());
            QVERIFY2(close(impact.separationTime, expected.separationTime, 1e-12 * expected.separationTime),
                     where.c_str());
            const Groups& g = expected.scene.groups;
            QVERIFY2(close((1 - g.gamma) * impact.peakForce / (2 * g.beta), expected.residualPenetration,
                           1e-12 * (1 + expected.residualPenetration)),
                     where.c_str());
        }
        QCOMPARE(row, 80);
    }

    void detailDoesNotChangeTheRebound() {
        for (const ReferenceCase& expected : referenceCases()) {
            const double short_ = solve(expected.scene, Detail::cor).cor;
            QCOMPARE(solve(expected.scene, Detail::ledger).cor, short_);
            QCOMPARE(solve(expected.scene, Detail::histories).cor, short_);
        }
    }

    void agreesWithPublishedAndPrecomputedValues_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        QTest::addColumn<double>("tau");
        QTest::addColumn<double>("delta");
        QTest::addColumn<double>("cor");
        const auto row = [](const char* source, PulseShape shape, double beta, double gamma, double tau,
                            double delta, double e) {
            QTest::newRow(source) << int(shape) << beta << gamma << tau << delta << e;
        };
        const PulseShape rectangular = PulseShape::rectangular;
        row("paper Fig. 4 (a)", rectangular, 0.5, 1, 10, 0, 1.4010824845070556);
        row("paper Fig. 4 (b)", rectangular, 0.5, 0.1, 10, 0, 0.40671074387478970);
        row("paper Fig. 8 at delta 0.521", rectangular, 0.5, 1, 10, 0.521, 0.84210576467383562);
        row("soft rock, many re-contacts", rectangular, 0.01, 0.1, 10, 0, 0.14105214688032185);
        row("nearly elastic", rectangular, 0.5, 0.99999999, 10, 0.1, 1.2742670575735909);
        row("soft reference case", PulseShape::rigidBody, 5e-4, 1, 1, 0, 0.99999999498851341);
        row("soft elastic, many reflections", rectangular, 0.001, 1, 0.6, 0, 1.0000500288434207);
        row("nearly rigid with a gap", rectangular, 1e8, 0.1, 10, 0.3, 0.99999998802999747);
        row("short rod, gap 0", rectangular, 0.5, 1, 0.3, 0, 0.95667);
        row("short rod, gap 1", rectangular, 0.5, 1, 0.3, 1, 0.99464);
        row("short rod, gap 2", rectangular, 0.5, 1, 0.3, 2, 0.99464);
    }
    void agreesWithPublishedAndPrecomputedValues() {
        QFETCH(int, shape);
        QFETCH(double, beta);
        QFETCH(double, gamma);
        QFETCH(double, tau);
        QFETCH(double, delta);
        QFETCH(double, cor);
        const double tolerance = tau == 0.3 ? 5e-6 : 1e-13;  // the last three are given to five places
        const Impact impact = solve({PulseShape(shape), {beta, gamma, tau, delta}});
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QVERIFY(close(impact.cor, cor, tolerance));
    }

    void separateReflectionsFollowTheClosedForm() {
        // overlap of order exp(−β(2τ − 1)) and smaller than rounding here
        for (const double beta : {0.05, 0.3, 0.5, 1.0, 1.2564, 1.2565, 2.0, 5.0, 40.0, 1e3}) {
            const double e = cor(PulseShape::rectangular, beta, 1, 40 / beta + 1, 0);
            QVERIFY2(close(e, closedFormCor(beta), 1e-13 / std::min(beta, 1.0)), formatNumber(beta).c_str());
        }
    }

    void equalWorkPointIsTheReferenceCase() {
        for (const double beta : {1e-3, 0.1, 2.5, 30.0, 1e4})
            for (const double gamma : {1.0, 0.7, 0.1, 0.01}) {
                const double pulse = cor(PulseShape::rectangular, beta, gamma, 0.5, 0);
                const double reference = cor(PulseShape::rigidBody, beta, gamma, 0.5, 0);
                QVERIFY(close(pulse, reference, 1e-13));
            }
    }

    void reboundIsPeriodicInTheGapOfALongRod() {
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine})
            for (const double fraction : {0.0, 0.125, 0.40625, 0.875})  // exact in binary
                for (const double gamma : {1.0, 0.1}) {
                    const double e = cor(shape, 0.5, gamma, 3, fraction);
                    for (const double whole : {1.0, 2.0, 7.0, 1048576.0})
                        QVERIFY(close(cor(shape, 0.5, gamma, 3, fraction + whole), e, 2e-14));
                }
    }

    void aShortRodIsPeriodicOnlyAfterTheAcceleration() {
        const double tau = 0.3;
        const double first = cor(PulseShape::rectangular, 0.5, 1, tau, 0.25);
        const double later = cor(PulseShape::rectangular, 0.5, 1, tau, 3.25);
        QVERIFY(std::abs(first - later) > 1e-3);
        QVERIFY(close(cor(PulseShape::rectangular, 0.5, 1, tau, 12.25), later, 1e-13));
    }

    void theReferenceCaseDependsOnStiffnessTimesTransitTimeOnly() {
        for (const double tau : {0.07, 1.0, 13.0, 700.0})
            QVERIFY(close(cor(PulseShape::rigidBody, 3 / tau, 0.3, tau, 0),
                          cor(PulseShape::rigidBody, 3, 0.3, 1, 0), 1e-13));
    }

    void rigidRockThrowsTheRodBackWithItsSpeed() {
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::halfSine, PulseShape::rigidBody})
            for (const double gamma : {1.0, 0.1, 1e-3})
                // what the rock gives way by shrinks with 1/β, and e − 1 with it: at most −3.2/β, of the half
                // sine
                for (const double beta : {1e6, 1e9})
                    QVERIFY(close(cor(shape, beta, gamma, 3, 0), 1, 4 / beta));
    }

    void softReferenceReboundsWithTheRootOfGamma() {
        for (const double gamma : {1.0, 0.5, 0.1, 0.01})
            QVERIFY(close(cor(PulseShape::rigidBody, 1e-6, gamma, 1, 0), std::sqrt(gamma), 2e-3));
    }

    void nearlyElasticRockIsContinuousWithElasticRock() {
        for (const double delta : {0.0, 0.1, 0.6, 1.3}) {
            const double elastic = cor(PulseShape::rectangular, 0.5, 1, 10, delta);
            for (const double distance : {1e-4, 1e-8, 1e-12, 1e-15}) {
                const double e = cor(PulseShape::rectangular, 0.5, 1 - distance, 10, delta);
                QVERIFY(close(e, elastic, 3 * distance + 1e-13));
            }
        }
    }

    void bothRepresentationsGiveTheSameRebound() {
        // the representation changes at β τ = 1.5, and at γ = 0.7
        ContactMarch<SeriesBasis<double>> series;
        RandomScenes scenes({0.02, 1e3, 0.01, 0.2, 100, 10}, 7);
        scenes.forEachSolved(200, Detail::cor, [&](const Scene& scene, const Impact& chosen) {
            Impact impact;
            series.solve(problemOf(scene), Detail::cor, impact);
            QVERIFY2(close(chosen.cor, impact.cor, chosen.corError + impact.corError),
                     describe(scene).c_str());
        });
    }

    void errorBoundHoldsAgainstExtendedPrecision() {
        ContactMarch<SeriesBasis<long double>> extended;
        RandomScenes scenes(engineeringDomain, 3);
        int compared = 0, outside = 0;
        std::vector<double> ratios;
        scenes.forEachSolved(1000, Detail::cor, [&](const Scene& scene, const Impact& impact) {
            Impact exact;
            extended.solve(problemOf(scene), Detail::cor, exact);
            const double error = std::abs(impact.cor - exact.cor);
            QVERIFY2(error <= 1e-12, describe(scene).c_str());
            ++compared;
            outside += error > impact.corError;
            ratios.push_back(impact.corError / std::max(error, 1e-17));
        });
        QVERIFY2(outside <= compared / 100, std::to_string(outside).c_str());
        std::nth_element(ratios.begin(), ratios.begin() + compared / 2, ratios.end());
        QVERIFY(ratios[compared / 2] < 1e4);
    }

    void extremesStayAccurate() {
        ContactMarch<SeriesBasis<long double>> extended;
        RandomScenes scenes(extremeDomain, 4);
        int compared = 0;
        scenes.forEachSolved(700, Detail::cor, [&](const Scene& scene, const Impact& impact) {
            Impact exact;
            extended.solve(problemOf(scene), Detail::cor, exact);
            if (exact.outcome != Outcome::rebounded) return;
            QVERIFY2(std::abs(impact.cor - exact.cor) <= 1e-9, describe(scene).c_str());
            ++compared;
        });
        QVERIFY(compared > 560);  // four in five here, too
    }

    void historiesSatisfyTheDelayEquation() {
        RandomScenes scenes({0.01, 100, 0.01, 0.1, 30, 3}, 5);
        int checked = 0;
        scenes.forEachSolved(180, Detail::histories, [&](const Scene& scene, const Impact& impact) {
            if (!impact.skips.empty()) return;  // the recording is not contiguous in time
            ++checked;
            // a look-up one round trip earlier errs by the rounding of time, times the steepest slope
            const double steepness = scene.groups.beta / scene.groups.gamma / scene.groups.tau;
            // where pieces are many, joined ones may differ from the wave
            const double joined = impact.pieces > 32 ? 2 * JoiningBudget(problemOf(scene)).mostDeviation : 0;
            const double tolerance = joined + 1e-12 + 1e-14 * (1 + steepness) * (1 + impact.incident.end());
            QVERIFY2(worstViolation(impact, problemOf(scene).force()) < tolerance, describe(scene).c_str());
        });
        QVERIFY2(checked > 100, std::to_string(checked).c_str());
    }

    void zeroForceContactDoesNotChatter() {
        // after the first peak F decays to 1e-300 before the next wave arrives
        const Impact impact = solve({PulseShape::rectangular, {50, 0.1, 30, 0}}, Detail::ledger);
        QCOMPARE(impact.contacts, 1);
        QVERIFY(impact.events.size() <= 8);
        QVERIFY(impact.pieces < 200);
    }

    void theRockIsNotLeftWhileTheIncidentWavePushes() {
        // F = e^−43 after 20 t0: a contact without force, neither left nor found again
        const Scene scene{PulseShape::rectangular, {0.5, 0.1, 10, 0.521}};
        QCOMPARE(solve(scene, Detail::cor).contacts, 2);
        const Impact impact = solve(scene, Detail::ledger);
        QCOMPARE(impact.contacts, 2);
        QCOMPARE(impact.events.size(), std::size_t(7));
        QVERIFY(close(impact.events[4].time, 31.217, 1e-3));  // the first separation
        const Impact halfSine = solve({PulseShape::halfSine, {0.5, 0.1, 10, 0}}, Detail::ledger);
        QCOMPARE(halfSine.contacts, 1);
    }

    void aRodLeftWithoutMomentumIsAnswered() {
        const Scene scene{PulseShape::piston, {3.1419362199829686, 1, 0.16017828902955503, 0}, 4.865};
        const Impact impact = solve(scene);
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QVERIFY(close(impact.cor, 3.9e-14, impact.corError));  // in long double
        QVERIFY(impact.corError < 3e-12);
    }

    void theSoftestReferenceCaseIsAMassOnASpring() {
        for (const double gamma : {1.0, 0.3, 1e-3}) {
            const Impact impact = solve({PulseShape::rigidBody, {1e-20, gamma, 10, 0}}, Detail::ledger);
            QCOMPARE(impact.outcome, Outcome::rebounded);
            QVERIFY(close(impact.cor, std::sqrt(gamma), 1e-15));
            QVERIFY(impact.corError < 1e-14);
            QVERIFY(close(impact.peakForce / std::sqrt(1e-21), 1, 1e-12));
            QVERIFY(close(impact.hammerWork - impact.rockWork - impact.finalEnergy, 0, 1e-15));
            QCOMPARE(impact.contacts, 1);
        }
        QCOMPARE(solve({PulseShape::rigidBody, {1e-20, 1, 10, 0}}, Detail::histories).outcome,
                 Outcome::notSolved);
    }

    void theExpansionForSoftRockMeetsTheMarch() {
        for (const double gamma : {1.0, 0.5, 0.01})
            for (const double softness : {1e-4, 1e-6}) {
                const Groups groups{softness * gamma / 0.5, gamma, 0.5, 0};
                const Impact march = solve({PulseShape::rigidBody, groups}, Detail::ledger);
                const Impact expansion =
                    softReference(problemOf(Scene{PulseShape::rigidBody, groups}), Detail::ledger);
                QVERIFY(close(expansion.cor, march.cor, expansion.corError + march.corError));
                const double second = softness * std::sqrt(softness);  // the order left out, relative
                QVERIFY(close(expansion.peakForce / march.peakForce, 1, second + 1e-11));
                QVERIFY(close(expansion.contactDuration / march.contactDuration, 1, second + 1e-11));
                QVERIFY(close(expansion.rockWork, march.rockWork, second + 1e-11));
                QCOMPARE(expansion.events.size(), march.events.size());
            }
    }

    void workGrowsLikeTheRoundTripsOfASoftContact() {
        const long once = solve({PulseShape::rectangular, {1e-4, 1, 0.6, 0}}).pieces;
        const long tenTimes = solve({PulseShape::rectangular, {1e-6, 1, 0.6, 0}}).pieces;
        QVERIFY(tenTimes < 12 * once);
        QVERIFY(tenTimes > 5 * once);  // else the count says nothing
    }

    void workDoesNotGrowWithTheRate() {
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::halfSine, PulseShape::triangular})
            for (const double gamma : {1e-6, 1e-4, 0.1, 1.0}) {
                const Impact impact = solve({shape, {1e9, gamma, 3, 0.3}});
                QCOMPARE(impact.outcome, Outcome::rebounded);
                QVERIFY2(impact.pieces < 100, std::to_string(impact.pieces).c_str());
            }
    }

    void slowDriftAndLargeGapsAreSkipped() {
        const Impact impact = solve({PulseShape::rectangular, {0.5, 0.1, 10, 1e12 + 0.5}});
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QVERIFY(impact.pieces < 200);
        QVERIFY(close(impact.cor, cor(PulseShape::rectangular, 0.5, 0.1, 10, 0.5), 1e-13));
    }

    void aGapBeyondTheDigitsOfAFractionStillTakesItsTime() {
        // δ = 1e17 has no fraction: the rod flies 1e17 periods and meets the rock as with δ = 1
        const Impact near = solve({PulseShape::rectangular, {0.5, 0.1, 10, 1}}, Detail::ledger);
        const Impact far = solve({PulseShape::rectangular, {0.5, 0.1, 10, 1e17}}, Detail::ledger);
        QVERIFY(close(far.cor, near.cor, 1e-13));
        QVERIFY(close(far.firstContactTime, 2e18, 1e3));
        QVERIFY(close(far.contactDuration, near.contactDuration, 1e-9));
    }

    void aSummaryIsThatOfTheWholeMarch() {
        RandomScenes scenes(engineeringDomain, 31);
        scenes.forEachSolved(1000, Detail::summary, [](const Scene& scene, const Impact& impact) {
            const Impact whole = solve(scene, Detail::histories);
            const std::string where = describe(scene);
            QVERIFY2(impact.cor == whole.cor && impact.contacts == whole.contacts, where.c_str());
            QVERIFY2(impact.peakForce == whole.peakForce && impact.rockWork == whole.rockWork, where.c_str());
            QVERIFY2(impact.firstContactTime == whole.firstContactTime &&
                         impact.separationTime == whole.separationTime,
                     where.c_str());
            QVERIFY2(close(impact.contactDuration, whole.contactDuration, 1e-14 * whole.contactDuration),
                     where.c_str());
            QVERIFY2(impact.hammerWork == whole.hammerWork, where.c_str());
            QVERIFY2(std::isnan(impact.finalMomentum) && std::isnan(impact.finalEnergy), where.c_str());
            QVERIFY2(close(impact.rockWork + whole.finalEnergy, impact.hammerWork, 1e-11), where.c_str());
        });
    }

    void aLongBlowEndsWhenTheRodIsProvenToStayAway() {
        Scene piston{PulseShape::piston, {12, 0.06, 0.36, 1.2}};
        piston.impedanceRatio = 14;  // 322 steps over 447 round trips
        const Impact quick = solve(piston), whole = solve(piston, Detail::ledger);
        QCOMPARE(quick.cor, whole.cor);
        QCOMPARE(quick.contacts, whole.contacts);
        QVERIFY2(20 * quick.pieces < whole.pieces, std::to_string(quick.pieces).c_str());
    }

    void aRockOfAnyStiffnessThrowsTheRodBack() {
        for (const double beta : {1e15, 1e100, 1e308}) {
            const Impact impact = solve({PulseShape::rectangular, {beta, 0.1, 10, 0}});
            QCOMPARE(impact.outcome, Outcome::rebounded);
            QVERIFY(close(impact.cor, 1, 1e-14));
        }
    }

    void aStopEndsASolutionThatTakesSeconds() {
        const Scene endless{PulseShape::rectangular, {1e-300, 0.1, 10, 0}};
        ExactSolver solver;
        const Impact whole = solver.solve(problemOf(endless));
        QVERIFY(whole.pieces > 1'000'000);
        std::stop_source source;
        source.request_stop();
        for (const Detail detail : {Detail::cor, Detail::histories}) {
            const Impact stopped = solver.solve(problemOf(endless), detail, source.get_token());
            QCOMPARE(stopped.outcome, Outcome::notSolved);
            QCOMPARE(stopped.reason.text(), std::string("stopped"));
            QVERIFY(stopped.pieces < 20'000);  // a millisecond
        }
        QCOMPARE(cor(PulseShape::rectangular, 0.5, 1, 10, 0),
                 solver.solve(problemOf(Scene{PulseShape::rectangular, {0.5, 1, 10, 0}}))
                     .cor);  // and leaves the solver as good as new
    }

    void workBeyondTheLimitIsReportedAsNotSolved() {
        const Scene scene{PulseShape::rectangular, {1e-6, 0.1, 0.6, 0}};
        ExactSolver solver(1000);
        const Impact impact = solver.solve(problemOf(scene));
        QCOMPARE(impact.outcome, Outcome::notSolved);
        QVERIFY(!impact.reason.isEmpty());
        QVERIFY(impact.pieces < 2000);
        QCOMPARE(solve(scene).outcome, Outcome::rebounded);
    }
};

QTEST_GUILESS_MAIN(TestExactSolver)
#include "tst_exact_solver.moc"
