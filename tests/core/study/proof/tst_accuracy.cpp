// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time over a short ladder.
#include <QTest>

#include "core/study/proof/accuracy.h"
#include "core/study/proof/force_difference.h"
#include "core/study/proof/string_accuracy.h"
#include "core/yaml/examples.h"
#include "tests/support/scenario.h"
#include "tests/support/scenario_texts.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const Scenario elastic = dimensionless(PulseShape::rectangular, {0.5, 1, 10, 0});
const Scenario bilinear = dimensionless(PulseShape::rectangular, {0.5, 0.1, 10, 0});

}  // namespace

class TestAccuracy : public QObject {
    Q_OBJECT

  private slots:
    // A reference with cells half as large: what a method says of its error must hold against it, and
    // constant cells are what they are.
    void cellsOfAStringAreBetterThanAPlainLattice() {
        const Scenario scenario = parsed(std::string(findExample("t38_string")->text)).scenario;
        std::vector<std::size_t> told;
        const StringAccuracy found =
            measureStringAccuracy(scenario, {}, [&](const StringAccuracy& soFar, double done) {
                told.push_back(soFar.rows.size());
                QVERIFY(done > 0 && done <= 1);
            });
        QVERIFY(found.reason.isEmpty() && !found.isStopped);
        QCOMPARE(told.size(), found.rows.size());
        QCOMPARE(told.back(), found.rows.size());
        for (const StringAccuracyRow& row : found.rows) {
            QVERIFY(row.time.least > 0 && row.time.median >= row.time.least && row.cells > 0);
            if (row.method == StringMethod::plain) {
                QVERIFY(row.error > 1e-6 && row.error < 1e-2);  // strings: 6.9e-6 at the finest
            } else {
                QVERIFY(row.error < 1e-9);
                QVERIFY(row.error <= row.stated + found.reference);
            }
        }
    }

    void aStoppedMeasurementOfAStringHasNoRowWithoutATime() {
        const Scenario scenario = parsed(std::string(findExample("t38_string")->text)).scenario;
        std::stop_source stop;
        const StringAccuracy found =
            measureStringAccuracy(scenario, stop.get_token(), [&](const StringAccuracy& soFar, double) {
                if (soFar.rows.size() == 2) stop.request_stop();
            });
        QVERIFY(found.isStopped);
        QCOMPARE(found.rows.size(), std::size_t{2});
    }

    void errorsAreThoseOfTheTwoPublishedBlows() {
        const std::vector<int> ladder{250, 500, 1000};
        const Accuracy found = measureAccuracy(elastic, ladder);
        QCOMPARE(found.rows.size(), std::size_t(8));
        QVERIFY(!found.isStopped);
        const AccuracyRow& exact = found.rows[0];
        QVERIFY(exact.choice.method == Method::exact && exact.corError < 1e-14 && exact.forceError < 1e-14);
        const AccuracyRow& closed = found.rows[1];
        QVERIFY(closed.choice.method == Method::closedForm && std::abs(closed.corError - 5.4505e-5) < 1e-8);
        QVERIFY(closed.corEstimate >= closed.corError);
        for (const AccuracyRow& row : found.rows) {
            QVERIFY(row.corError <= row.corEstimate);
            QVERIFY(row.forceErrorInMiddles <= row.forceError);
            QVERIFY(row.time.runs >= 9 && row.time.least > 0 && row.time.median >= row.time.least);
            QVERIFY(row.sameAsMoved && row.contacts == 1 && row.events == 2);
        }
        // theory §6: 1.1e-7 at 1 000 segments, and order 2
        QVERIFY(found.rows[4].corError > 1.1e-7 / 3 && found.rows[4].corError < 3 * 1.1e-7);
        QVERIFY2(std::abs(found.latticeOrder - 2) < 0.3, qPrintable(QString::number(found.latticeOrder)));
        // what is drawn as steps differs by half the change of the force in one, β (2g − F) Δ/2 at first
        QVERIFY(std::abs(found.rows[4].forceError / (0.5 * 2 * 0.01 / 2) - 1) < 0.05);
        // moved waves of 1 000 segments cost more than a ring of them, and that more than the exact solution
        QVERIFY(found.rows[7].time.least > found.rows[4].time.least);
        QVERIFY(found.rows[4].time.least > exact.time.least);

        const Accuracy inelastic = measureAccuracy(bilinear, ladder);
        QCOMPARE(inelastic.rows.size(), std::size_t(7));  // no closed form
        // theory §6: about 1e-5 at 1 000 segments
        QVERIFY(inelastic.rows[3].corError > 3e-6 && inelastic.rows[3].corError < 3e-5);
        QVERIFY(inelastic.rows[0].corError < 1e-14);
        QVERIFY(inelastic.residuals.law < 1e-14 && inelastic.residuals.points > 100);
    }

    void speedsAreRelativeToThePapersChoice() {
        const Accuracy found = measureAccuracy(elastic, {100, paperSegments});
        const AccuracyRow& paper = found.rows.back();
        QVERIFY(paper.choice.lattice.waves == LatticeWaves::moved && paper.speed == 1);
        for (const AccuracyRow& row : found.rows)
            QVERIFY(std::abs(row.speed * row.time.median / paper.time.median - 1) < 1e-12);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        QVERIFY2(found.rows[0].speed > 5e4, qPrintable(QString::number(found.rows[0].speed)));
#endif
        const Accuracy without = measureAccuracy(elastic, {100});
        QVERIFY(std::isnan(without.rows[0].speed) && std::isnan(without.latticeOrder));
    }

    void rowsThatCannotBeSolvedSayWhy() {
        const Accuracy found =
            measureAccuracy(dimensionless(PulseShape::halfSine, {5, 0.05, 10, 0}), {100, 1000});
        QCOMPARE(found.rows.size(), std::size_t(5));
        for (const AccuracyRow& row : found.rows) {
            const bool isTooCoarse =
                row.choice.method == Method::lattice && row.choice.lattice.segments == 100;
            QCOMPARE(row.outcome == Outcome::rebounded, !isTooCoarse);
            QCOMPARE(row.reason.isEmpty(), !isTooCoarse);
            QCOMPARE(std::isnan(row.corError), isTooCoarse);
        }
    }

    void progressGrowsToTheEnd() {
        std::vector<double> told;
        measureAccuracy(bilinear, {100, 200}, {}, [&](double done) { told.push_back(done); });
        QVERIFY(told.size() > 40);
        QVERIFY(std::ranges::is_sorted(told) && told.front() > 0);
        QVERIFY(told.back() > 0.999 && told.back() < 1.001);
    }

    void aStopLeavesRowsOut() {
        std::stop_source source;
        int calls = 0;
        const Accuracy found = measureAccuracy(bilinear, latticeLadder(), source.get_token(), [&](double) {
            if (++calls == 15) source.request_stop();
        });
        QVERIFY(found.isStopped && calls == 15);
        QCOMPARE(found.rows.size(), std::size_t(2));
    }

    void forcesThatDifferAreFoundWhereTheyDo() {
        // the same blow on a rock of half the stiffness: F1 = 2 (1 − e^(−βt)) differs most at its end
        const Impact stiff = solve({PulseShape::rectangular, {2, 1, 10, 0}}, Detail::histories);
        const Impact soft = solve({PulseShape::rectangular, {1, 1, 10, 0}}, Detail::histories);
        const double atEnd = 2 * (std::exp(-1) - std::exp(-2));
        QVERIFY(forceDifference(stiff, stiff).largest < 1e-15);  // pieces meet within rounding
        QVERIFY(std::abs(forceDifference(stiff, soft).largest - forceDifference(soft, stiff).largest) < 0.05);
        QVERIFY(forceDifference(stiff, soft).largest >= atEnd - 1e-14);
    }
};

QTEST_GUILESS_MAIN(TestAccuracy)
#include "tst_accuracy.moc"
