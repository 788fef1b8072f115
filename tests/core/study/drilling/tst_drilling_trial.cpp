// SPDX-License-Identifier: GPL-3.0-or-later
// Random rods and strings under many blows: what holds of all of them, and how often the stated error of the
// mean penetration covers a march with a quarter of the cell. DRILLWAVE_DRILLING_SCENES says how many rods,
// and a quarter as many strings.
#include <QTest>

#include <cmath>

#include "core/contact/contact_law.h"
#include "core/study/drilling/drilling_statistics.h"
#include "core/study/drilling/drilling_study.h"
#include "tests/support/drilling_scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr long blowsOfTrial = 150, settleOfTrial = 50, blowsOfBalance = 40;
constexpr std::size_t penetration = quantityPlace(&DrillingBlow::penetration);

std::string described(const DrillingProblem& problem, int number) {
    const Problem& blow = problem.blow;
    std::string text = QStringLiteral("%1: beta %2 gamma %3 n_b %4 phi %5 loss %6 sections %7 gap %8")
                           .arg(number)
                           .arg(blow.law.beta)
                           .arg(blow.law.gamma)
                           .arg(problem.interval / (2 * blow.transitTime()))
                           .arg(problem.feedForce * problem.interval)
                           .arg(problem.waveLosses.back())
                           .arg(blow.sections.size())
                           .arg(blow.gap)
                           .toStdString();
    if (problem.machine)
        text += QStringLiteral(" mu %1 zeta %2 kappa %3")
                    .arg(problem.machine->mass / blow.mass())
                    .arg(problem.machine->damping)
                    .arg(problem.machine->stiffness)
                    .toStdString();
    return text;
}

/// Cells a quarter as long, whose fronts and intervals are at the same times.
DrillingGrid quartered(DrillingGrid grid) {
    const std::vector<double> places = grid.cuts.places();
    grid.cell /= 4;
    for (double& trip : grid.roundTrips) trip *= 4;
    grid.cellsOfInterval *= 4;
    grid.cuts.begin(grid.cell, {}, {});
    for (const double place : places) {
        const double own = 4 * place - std::floor(4 * place);
        if (own > 1e-9 && own < 1 - 1e-9) grid.cuts.endPartAt(own);
    }
    return grid;
}

/// Findings over all scenes.
struct Trial {
    int scenes = 0, done = 0, pushedBack = 0, notSolved = 0, compared = 0, covered = 0, coveredByBoth = 0,
        unbalanced = 0;
    double momentum = 0, energy = 0, deepestPull = 0;
};

void tell(const Trial& trial) {
    qInfo(
        "%d scenes: %d done, %d pushed back, %d not solved; %d of %d covered, %d with the error of the finer "
        "one; "
        "momentum to %.2g, energy to %.2g (%d above 1e-3); deepest pull %.2g",
        trial.scenes, trial.done, trial.pushedBack, trial.notSolved, trial.covered, trial.compared,
        trial.coveredByBoth, trial.momentum, trial.energy, trial.unbalanced, trial.deepestPull);
}

}  // namespace

class TestDrillingTrial : public QObject {
    Q_OBJECT

  private slots:
    void itHoldsOfAll_data();
    void itHoldsOfAll();

  private:
    static void tryScene(const DrillingProblem& problem, const std::string& where, Trial& trial);
    static void balance(const DrillingProblem& problem, const std::string& where, Trial& trial);
};

void TestDrillingTrial::itHoldsOfAll_data() {
    const int rods = tries("DRILLWAVE_DRILLING_SCENES", 16);
    QTest::addColumn<bool>("isString");
    QTest::addColumn<int>("count");
    QTest::newRow("rods") << false << rods;
    QTest::newRow("strings") << true << rods / 4;
}

/// Momentum to rounding, energy to the cells, and nothing that pulls.
void TestDrillingTrial::balance(const DrillingProblem& problem, const std::string& where, Trial& trial) {
    const DrillingGrid grid = drillingGridOf(problem, 40);
    const RecordLength length{.blows = blowsOfBalance, .histories = BlowRange{5, 8}};
    const DrillingRecord record = recordOf(problem, grid, length, {}, {});
    if (record.blows.empty()) return;
    const double fed = static_cast<double>(record.blows.size()) * grid.interval() * problem.feedForce;
    trial.momentum = std::max(trial.momentum, std::abs(record.momentumResidual) / fed);
    const double energy = std::abs(record.ledger.residual()) / record.ledger.hammer;
    trial.energy = std::max(trial.energy, energy);
    if (energy > 1e-3) {
        ++trial.unbalanced;
        qInfo("energy %.3g: %s", energy, where.c_str());
    }
    for (const DrillingInstant& instant : record.instants)
        trial.deepestPull = std::min({trial.deepestPull, instant.force, instant.damperForce});
    for (const DrillingBlow& blow : record.blows)
        trial.deepestPull = std::min({trial.deepestPull, blow.faceImpulse, blow.rockImpulse});
}

void TestDrillingTrial::tryScene(const DrillingProblem& problem, const std::string& where, Trial& trial) {
    ++trial.scenes;
    balance(problem, where, trial);
    const auto marched = [&](const DrillingGrid& cells) {
        return recordOf(problem, cells, {.blows = blowsOfTrial}, {}, {});
    };
    const DrillingGrid grid = drillingGridOf(problem, 20);
    const DrillingRecord main = marched(grid);
    if (main.outcome == DrillingOutcome::notSolved) {
        ++trial.notSolved;
        qInfo("%s: %s", main.reason.text().c_str(), where.c_str());
        return;
    }
    if (main.outcome == DrillingOutcome::pushedBack) {
        ++trial.pushedBack;
        const double impulse = meanImpulse(main.blows, growingBlows);
        const double phi = problem.feedForce * grid.interval() / impulse;
        QVERIFY2(phi < 1.1, (where + ", pushed back at " + std::to_string(phi)).c_str());
        return;
    }
    ++trial.done;
    const DrillingRecord other = marched(comparedDrillingGridOf(problem, 20));
    const DrillingRecord fine = marched(quartered(grid));
    if (other.outcome != DrillingOutcome::done || fine.outcome != DrillingOutcome::done) return;
    const auto spread = [&](const DrillingRecord& record) {
        return statisticsOf(record.blows, settleOfTrial, problem.blow.velocity()).spreads[penetration];
    };
    const BlowSpread own = spread(main), ofFine = spread(fine);
    const double stated =
        own.meanError.value_or(0) + coveringCells * std::abs(own.mean - spread(other).mean) + 1e-9;
    const double off = std::abs(own.mean - ofFine.mean);
    ++trial.compared;
    trial.covered += off <= stated;
    trial.coveredByBoth += off <= stated + ofFine.meanError.value_or(0);
    if (off > stated)
        qInfo("off by %.3g of %.3g, mean %.4g +- %.2g: %s", off, stated, ofFine.mean,
              ofFine.meanError.value_or(0), where.c_str());
}

void TestDrillingTrial::itHoldsOfAll() {
    QFETCH(bool, isString);
    QFETCH(int, count);
    std::mt19937 random(isString ? 77 : 7);
    Trial trial;
    for (int i = 0; i < count; ++i) {
        const DrillingProblem problem = randomDrilling(random, isString);
        tryScene(problem, described(problem, i), trial);
        if (QTest::currentTestFailed()) return;
        if (trial.scenes % 50 == 0) tell(trial);
    }
    tell(trial);
    QCOMPARE(trial.notSolved, 0);
    // sums of some ten thousand cells a blow
    QVERIFY(trial.momentum < 1e-11);
    QVERIFY(trial.unbalanced <= std::max(1, count / 50));
    QVERIFY(trial.deepestPull > -1e-9);
    // 95 % of many; of few, one may be missed
    QVERIFY(trial.covered >= trial.compared * 95 / 100 - 1);
    QVERIFY(trial.done > count / 2);
}

QTEST_GUILESS_MAIN(TestDrillingTrial)
#include "tst_drilling_trial.moc"
