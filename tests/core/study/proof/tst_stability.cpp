// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of the stability study: they reach the ends of the domain, and find what is wrong.
#include <QTest>
#include <set>

#include "core/study/proof/stability.h"
#include "core/wave/exact/exact_solver.h"

using namespace drillwave;

namespace {

std::vector<StabilityCase> everyNth(std::size_t n) {
    std::vector<StabilityCase> some;
    const auto all = stabilityCases();
    for (std::size_t i = 0; i < all.size(); i += n) some.push_back(all[i]);
    return some;
}

void ignoreProgress(const StabilityReport&) {}

}  // namespace

class TestStability : public QObject {
    Q_OBJECT

  private slots:
    void theCasesReachTheEndsOfTheDomain() {
        double leastBeta = 1, mostBeta = 1, leastGamma = 1, leastTau = 1, mostTau = 1, mostDelta = 0;
        std::set<PulseShape> shapes;
        for (const StabilityCase& c : stabilityCases()) {
            leastBeta = std::min(leastBeta, c.groups.beta);
            mostBeta = std::max(mostBeta, c.groups.beta);
            leastGamma = std::min(leastGamma, c.groups.gamma);
            leastTau = std::min(leastTau, c.groups.tau);
            mostTau = std::max(mostTau, c.groups.tau);
            mostDelta = std::max(mostDelta, c.groups.delta);
            shapes.insert(c.shape);
        }
        QCOMPARE(leastBeta, 1e-9);
        QCOMPARE(mostBeta, 1e12);
        QCOMPARE(leastGamma, 1e-9);
        QCOMPARE(leastTau, 0.01);
        QCOMPARE(mostTau, 1e4);
        QVERIFY(mostDelta >= 1e6);
        QCOMPARE(shapes.size(), std::size_t(8));
    }

    void theCasesHoldShortRodsAndChatteringBits() {
        std::set<PulseShape> onShortRods;
        int chattering = 0;
        ExactSolver solver;
        for (const StabilityCase& c : stabilityCases()) {
            if (c.groups.tau <= 0.4) onShortRods.insert(c.shape);
            if (c.name.starts_with("chatter") && chattering < 20)
                chattering += solver.solve(problemOf(c)).contacts > 10;
        }
        QCOMPARE(onShortRods.size(), std::size_t(8));
        QVERIFY(chattering >= 10);
    }

    void everySeventhCasePasses() {
        const StabilityReport report = checkStability(everyNth(7), 2, {}, ignoreProgress);
        QVERIFY(report.rows.size() > 300);
        int histories = 0, limits = 0, lattices = 0, bounds = 0;
        for (const StabilityRow& row : report.rows) {
            const std::string failure = (row.failures.empty() ? row.reason : row.failures.front()).text();
            QVERIFY2(row.passed(), (row.stabilityCase.name + ": " + failure).c_str());
            histories += row.leastForce.has_value();
            limits += row.limitDistance.has_value();
            lattices += row.latticeDistance.has_value();
            bounds += row.boundDistance.has_value();
        }
        QVERIFY(histories > 200);  // the checks are really made
        QVERIFY(limits > 50);
        QVERIFY(lattices > 10);
        QVERIFY(bounds > 300);
    }

    void rowsComeInTheOrderOfTheCasesOnAnyNumberOfThreads() {
        const auto cases = everyNth(97);
        const StabilityReport one = checkStability(cases, 1, {}, ignoreProgress);
        const StabilityReport two = checkStability(cases, 2, {}, ignoreProgress);
        QCOMPARE(one.rows.size(), cases.size());
        QCOMPARE(two.rows.size(), cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            QVERIFY(one.rows[i].stabilityCase == cases[i]);
            QCOMPARE(one.rows[i].cor, two.rows[i].cor);
        }
    }

    void aCaseBeyondTheWorkLimitIsCountedAsNotSolved() {
        // soft rock: a contact of fifty million round trips
        const StabilityCase softest{"softest", PulseShape::rectangular, 2, {1e-15, 1e-4, 0.6, 0}};
        const StabilityReport report = checkStability({softest}, 1, {}, ignoreProgress);
        QCOMPARE(report.notSolved(), std::size_t(1));
        QCOMPARE(report.failed(), std::size_t(0));
        QVERIFY(!report.rows.front().reason.isEmpty());
    }

    void aStopEndsTheRun() {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(checkStability(everyNth(50), 1, stop.get_token(), ignoreProgress).stopped);
    }
};

QTEST_GUILESS_MAIN(TestStability)
#include "tst_stability.moc"
