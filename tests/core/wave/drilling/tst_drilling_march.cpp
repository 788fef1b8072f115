// SPDX-License-Identifier: GPL-3.0-or-later
// Blow after blow on cells: what must be kept, what must come out, what must not matter (drilling).
#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "core/contact/contact_law.h"
#include "core/wave/drilling/drilling_march.h"
#include "core/wave/drilling/drilling_problem.h"
#include "core/wave/exact/exact_solver.h"
#include "tests/support/drilling_scenes.h"
#include "tests/support/network_scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Case B: β 0.5, γ 0.1, τ 3.5, n_b 12, η 0.1, with or without the soft damper of μ 6.8.
DrillingProblem caseB(double phi, double zeta) {
    DrillingProblem problem;
    problem.blow = problemOf(pulseForceOf(PulseShape::rectangular), {.beta = 0.5, .gamma = 0.1, .tau = 3.5});
    problem.interval = 2 * 3.5 * 12;
    problem.feedForce = phi / problem.interval;
    problem.waveLosses = {0.1};
    if (zeta > 0) problem.machine = MachineBody{.mass = 6.8 * 3.5, .damping = zeta, .stiffness = 0};
    return problem;
}

struct Marched {
    std::vector<DrillingBlow> blows;
    DrillingLedger ledger;
    double momentumResidual = 0;
};

Marched march(const DrillingProblem& problem, int cells, long blows) {
    DrillingMarch marching(problem, drillingGridOf(problem, cells));
    Marched result;
    for (long i = 0; i < blows; ++i) {
        if (!marching.takeBlow({})) qFatal("%s", std::string(marching.failureReason()).c_str());
        result.blows.push_back(marching.blow());
    }
    result.ledger = marching.ledger();
    result.momentumResidual = marching.momentumResidual();
    return result;
}

double d0(double length) {
    return length * lawUnitOfPenetration;
}

}  // namespace

class TestDrillingMarch : public QObject {
    Q_OBJECT

  private slots:
    void aSingleBlowIsThatOfTheExactSolver_data();
    void aSingleBlowIsThatOfTheExactSolver();
    void aSingleBlowOfAStringIsThatOfItsSolver_data();
    void aSingleBlowOfAStringIsThatOfItsSolver();
    void periodicMotionsAreThoseOfTheTheory_data();
    void periodicMotionsAreThoseOfTheTheory();
    void frontsOfBlowsLieOnCellEnds();
    void cellsAreNotHalvedBelowWhatIsAsked();
    void momentumAndEnergyAreKept_data();
    void momentumAndEnergyAreKept();
    void theEnergyErrorFallsWithTheSquareOfTheCell();
    void aHammerThatIsTakenAwayTakesWhatItsFacesHold();
    void aMatchedDashpotTakesAPushAndLetsATensionBack();
    void aFreeRodKeepsItsVelocityAndAPressedOneItsLength();
    void aRoundTripNeedNotBeWholeCells();
    void whatAJointTakesComesBack();
    void aWaveLosesItsShareInARoundTrip();
    void flightIsTheSameWaveTurned();
    void withoutBlowsTheRockCarriesTheFeed();
    void theSameCraterIsShakenDown();
    void forcesGapsAndImpulsesScaleTogether();
    void intervalsScatterAsTheSeedSays();
};

void TestDrillingMarch::aSingleBlowIsThatOfTheExactSolver_data() {
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("gap");
    QTest::addColumn<int>("cells");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("50 cells") << 0.1 << 0.0 << 50 << 1e-5;
    QTest::newRow("100 cells") << 0.1 << 0.0 << 100 << 1e-6;
    QTest::newRow("elastic rock") << 1.0 << 0.0 << 100 << 1e-6;
    QTest::newRow("a gap") << 0.3 << 0.4 << 100 << 1e-6;
}

/// A thrust of f I0, no damper, no loss: nothing but the blow acts.
void TestDrillingMarch::aSingleBlowIsThatOfTheExactSolver() {
    QFETCH(double, gamma);
    QFETCH(double, gap);
    QFETCH(int, cells);
    QFETCH(double, tolerance);
    DrillingProblem problem = caseB(1, 0);
    problem.blow.law.gamma = gamma;
    problem.blow.gap = gap;
    problem.waveLosses = {0};
    const Marched marched = march(problem, cells, 1);
    const Impact exact = ExactSolver().solve(problem.blow, Detail::histories);
    QVERIFY(exact.isSolved());
    const double cor = marched.blows[0].rockImpulse - 1;
    QVERIFY2(std::abs(cor - exact.cor) < tolerance, qPrintable(QString::number(cor - exact.cor)));
    QVERIFY(std::abs(marched.blows[0].peakForce - exact.peakForce) < 10 * tolerance);
    QCOMPARE(marched.blows[0].contacts, double(exact.contacts));
    QVERIFY(std::abs(d0(marched.blows[0].gap) - gap) < 1e-15);
}

void TestDrillingMarch::aSingleBlowOfAStringIsThatOfItsSolver_data() {
    QTest::addColumn<bool>("restrike");
    QTest::newRow("the hammer strikes once") << false;
    QTest::newRow("it may strike again") << true;
}

// A thrust that balances the mean reaction leaves no force: neither damper nor loss do anything.
void TestDrillingMarch::aSingleBlowOfAStringIsThatOfItsSolver() {
    QFETCH(bool, restrike);
    DrillingProblem problem;
    problem.blow = struck();
    hammerOf(problem.blow).face.restrike = restrike;
    problem.blow.sections = {{.impedance = 1, .transitTime = 0.5},
                             {.impedance = 1.3, .transitTime = 1},
                             {.impedance = 1.8, .transitTime = 0.25, .massAfter = 0.1},
                             {.impedance = 1, .transitTime = 1.5}};
    problem.blow.law = {.beta = 0.6, .gamma = 0.2};
    problem.interval = 60;
    problem.feedForce = 1 / problem.interval;  // m_h v0
    problem.waveLosses = {0, 0, 0, 0};
    const Marched marched = march(problem, 100, 1);
    const DrillingBlow& blow = marched.blows[0];
    Problem alone = problem.blow;
    alone.endTime = problem.interval;
    const Impact impact = solveNetwork(alone, {});
    QVERIFY(impact.isSolved());
    // in one lattice both come to the same, the other has contacts between its cells
    const double tolerance = 1e-6;
    const auto isNear = [&](double found, double expected, const char* what) {
        const bool near = std::abs(found - expected) < tolerance;
        if (!near) qInfo("%s: %.9g, not %.9g", what, found, expected);
        return near;
    };
    QVERIFY(isNear(blow.rockImpulse, impact.impulse, "impulse"));
    QVERIFY(isNear(blow.faceImpulse, impact.faceImpulse, "face"));
    QVERIFY(isNear(blow.peakForce, impact.peakForce, "peak"));
    QVERIFY(isNear(marched.ledger.rock / impact.hammerWork, impact.efficiency(), "efficiency"));
    QCOMPARE(blow.contacts, double(impact.contacts));
}

void TestDrillingMarch::periodicMotionsAreThoseOfTheTheory_data() {
    QTest::addColumn<double>("phi");
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("gap");
    QTest::addColumn<double>("penetration");
    QTest::newRow("phi 1.4") << 1.4 << 0.15 << 0.1 << 0.35546 << 0.793786;
    QTest::newRow("phi 1.2") << 1.2 << 0.15 << 0.1 << 1.12195 << 0.704678;
    QTest::newRow("phi 2.2") << 2.2 << 0.15 << 0.1 << 0.002950 << 0.788229;
    QTest::newRow("at rest") << 2.0 << 0.5 << 0.3 << 0.0 << 0.544516;
}

// As an independent plain lattice has them.
void TestDrillingMarch::periodicMotionsAreThoseOfTheTheory() {
    QFETCH(double, phi);
    QFETCH(double, zeta);
    QFETCH(double, gamma);
    QFETCH(double, gap);
    QFETCH(double, penetration);
    DrillingProblem problem = caseB(phi, zeta);
    problem.blow.law.gamma = gamma;
    const DrillingBlow last = march(problem, 40, 400).blows.back();
    QVERIFY(std::abs(d0(last.gap) - gap) < 1e-3);
    QVERIFY(std::abs(d0(last.penetration) - penetration) < 1e-4);
}

/// Inside a cell they cost a hundred times more than anything else gains.
void TestDrillingMarch::frontsOfBlowsLieOnCellEnds() {
    DrillingProblem problem = caseB(1.4, 0.15);
    const DrillingGrid whole = drillingGridOf(problem, 40);
    QCOMPARE(whole.cuts.count(), std::size_t{1});
    QVERIFY(std::abs(whole.rounding(problem)) < 1e-12);
    // where no cell divides the duration, all cells are cut where the force ends
    problem.blow.sections[0].transitTime = 3.5 * std::numbers::sqrt2;
    problem.interval = 2 * 3.5 * std::numbers::sqrt2 * 12;
    const DrillingGrid cut = drillingGridOf(problem, 40);
    QCOMPARE(cut.cuts.count(), std::size_t{2});
    const double place = 1 / cut.cell - std::floor(1 / cut.cell);
    QVERIFY(std::abs(cut.cuts.places()[1] - place) < 1e-9);
    problem.feedForce = 1.4 / problem.interval;
    const double coarse = march(problem, 20, 300).blows.back().gap;
    QVERIFY(std::abs(coarse - march(problem, 80, 300).blows.back().gap) < 2e-3);
}

/// The round trips of a string may share no cell larger than half of what would do.
void TestDrillingMarch::cellsAreNotHalvedBelowWhatIsAsked() {
    DrillingProblem problem;
    problem.blow = struck();
    problem.blow.sections = {{.impedance = 1, .transitTime = 0.51}, {.impedance = 1, .transitTime = 1}};
    problem.interval = 60;
    const auto cells = [&](int wanted) {
        return std::pair(drillingGridOf(problem, wanted).cell, comparedDrillingGridOf(problem, wanted).cell);
    };
    const auto [fine, finer] = cells(40);
    QVERIFY(std::abs(fine - 0.02) < 1e-12 && std::abs(finer - 0.01) < 1e-12);
    const auto [halved, shared] = cells(60);
    QVERIFY(std::abs(halved - 0.01) < 1e-12 && std::abs(shared - 0.02) < 1e-12);
    QCOMPARE(drillingGridOf(problem, 40).interval(), comparedDrillingGridOf(problem, 40).interval());
}

void TestDrillingMarch::momentumAndEnergyAreKept_data() {
    QTest::addColumn<bool>("isString");
    QTest::addColumn<int>("scenes");
    QTest::newRow("rods") << false << 150;
    QTest::newRow("strings") << true << 60;
}

/// In all of them, whatever rock, damper, hammer and thrust; and nothing pulls.
void TestDrillingMarch::momentumAndEnergyAreKept() {
    QFETCH(bool, isString);
    QFETCH(int, scenes);
    constexpr long blows = 20;
    std::mt19937 random(26);
    int solved = 0;
    for (int i = 0; i < scenes; ++i) {
        const DrillingProblem problem = randomDrilling(random, isString);
        const DrillingGrid grid = drillingGridOf(problem, 40);
        DrillingMarch marching(problem, grid);
        bool isDone = true;
        double damper = 0;
        for (long blow = 0; blow < blows && isDone; ++blow) {
            isDone = marching.takeBlow({});
            QVERIFY(!isDone || (marching.blow().peakForce >= 0 && marching.blow().gap >= 0));
            damper = std::min(damper, marching.blow().damperPeak);
        }
        if (!isDone) continue;
        ++solved;
        QVERIFY(damper >= 0 || !problem.machine);
        const double fed = blows * problem.feedForce * grid.interval();
        QVERIFY2(std::abs(marching.momentumResidual()) < 1e-12 * fed,
                 qPrintable(QStringLiteral("scene %1: %2").arg(i).arg(marching.momentumResidual() / fed)));
        const DrillingLedger& ledger = marching.ledger();
        const double brought = ledger.hammer + std::abs(ledger.feed);  // a strong feed outruns the hammer
        // faces that meet again do so inside a cell: that costs in the first order of its size
        const double tolerance = isString && problem.blow.hammer().face.restrike ? 5e-3 : 1e-3;
        QVERIFY2(std::abs(ledger.residual()) < tolerance * brought,
                 qPrintable(QStringLiteral("scene %1: %2").arg(i).arg(ledger.residual() / brought)));
        QVERIFY(ledger.waves >= -1e-12 * brought && ledger.faces >= -1e-12 * brought);
    }
    QVERIFY2(solved >= scenes * 95 / 100, qPrintable(QString::number(solved)));
}

void TestDrillingMarch::theEnergyErrorFallsWithTheSquareOfTheCell() {
    const DrillingProblem problem = caseB(1.2, 0.15);
    double before = 0;
    for (const int cells : {10, 40, 160}) {
        const DrillingLedger ledger = march(problem, cells, 50).ledger;
        const double error = std::abs(ledger.residual() / ledger.hammer);
        if (before > 0) QVERIFY2(error < before / 10, qPrintable(QString::number(before / error)));
        before = error;
    }
}

// ζ = 1 and S = 0: pressing it reflects nothing, lifted it is a free end.
/// Blows that come before the last one is over: the hammer still presses, by the stiffness of its face.
void TestDrillingMarch::aHammerThatIsTakenAwayTakesWhatItsFacesHold() {
    DrillingProblem problem;
    problem.blow = struck();
    hammerOf(problem.blow).face.stiffness = 1.5;
    problem.blow.sections = {{.impedance = 1.7, .transitTime = 0.5}, {.impedance = 1, .transitTime = 0.4}};
    problem.blow.law = {.beta = 1.75, .gamma = 0.4};
    problem.interval = 2.6;
    problem.feedForce = 8 / problem.interval;
    problem.waveLosses = {0, 0.25};
    const DrillingLedger ledger = march(problem, 40, 40).ledger;
    QVERIFY2(std::abs(ledger.residual()) < 1e-3 * ledger.hammer,
             qPrintable(QString::number(ledger.residual() / ledger.hammer)));
}

void TestDrillingMarch::aMatchedDashpotTakesAPushAndLetsATensionBack() {
    const std::vector<double> widths{0.025};
    for (const double wave : {0.5, -0.5}) {
        RearNode node({.impedance = 1, .face = {}, .machine = MachineBody{1e12, 1, 0}}, widths);
        node.beginBlow(0);
        const WaveCell back = WaveCell::constant(wave);
        for (int i = 0; i < 40; ++i) {
            const RearNode::Forces forces = node.step({}, back, nullptr, 0);
            const double leaving = (forces.sum() - back).mean();
            QVERIFY(std::abs(leaving - (wave > 0 ? 0 : -wave)) < 1e-10);  // the body moves by 1e-12
        }
    }
}

void TestDrillingMarch::aFreeRodKeepsItsVelocityAndAPressedOneItsLength() {
    const std::vector<double> widths{0.1};
    LossyLine line;
    line.begin(70, 0.1, 0.3, widths);
    // a uniform content is a uniform motion or, at a wall, a uniform compression
    for (const double wave : {-0.25, 0.4}) {
        line.fill(wave);
        for (int i = 0; i < 70 * 10'000; ++i) {
            const WaveCell out = line.arrive();
            line.enter(out, out, 0);
        }
        QVERIFY(std::abs(line.held() - 7 * wave) < 1e-13 * 7);
        QVERIFY(std::abs(line.arrive().mean() - wave) < 1e-13);
        QVERIFY(std::abs(line.lost()) < 1e-10);  // rounding of 700 000 cells
    }
}

/// A wave that a delay of a fraction of a cell projects: its mean passes exactly, what it loses is counted,
/// and what comes out is what went in, later.
void TestDrillingMarch::aRoundTripNeedNotBeWholeCells() {
    const std::vector<double> widths{0.1};
    constexpr double cells = 7.3;
    for (const double loss : {0.0, 0.2}) {
        LossyLine line;
        line.begin(cells, 0.1, loss, widths);
        double in = 0, out = 0, brought = 0, taken = 0;
        for (int i = 0; i < 200; ++i) {
            const WaveCell arriving = line.arrive();
            // a front, and a smooth wave behind it
            const auto wave = [&](double u) { return i < 3 || i > 40 ? 0 : std::cos(0.3 * (i + u)); };
            CellProjection entering;
            entering.add(0, 1, wave);
            line.enter(entering.cell(), arriving, 0);
            in += 0.1 * entering.cell().mean(), out += 0.1 * arriving.mean();
            brought += 0.1 * entering.cell().meanSquare(), taken += 0.1 * arriving.meanSquare();
            QVERIFY(std::abs(line.held() - (in - out)) < 1e-14);
            QVERIFY(std::abs(line.square() + line.lost() - (brought - taken)) < 1e-13);
            QVERIFY(line.lost() >= 0);
            if (loss == 0) QVERIFY(line.square() > -1e-13);
            if (loss == 0 && i > 20 && i < 40)
                QVERIFY(std::abs(arriving.value(0.4) - std::cos(0.3 * (i + 0.4 - cells))) < 1e-4);
        }
        QVERIFY(loss > 0 || std::abs(line.held()) < 1e-13);
    }
}

/// The momentum that a joint takes passes in the end, and no energy is made.
void TestDrillingMarch::whatAJointTakesComesBack() {
    ReturnedLoss loss(0.9, 0.5);
    double in = 0, out = 0, lost = 0;
    for (int i = 0; i < 4000; ++i) {
        const WaveCell wave = WaveCell::fromPowers({i < 20 ? 1.0 : 0.0, i < 20 ? 0.5 : 0, 0, 0});
        const WaveCell passed = loss.pass(wave, 0.05);
        if (i < 20) QVERIFY(std::abs(passed.start() - 0.9 * wave.start()) < 0.1);
        in += 0.05 * wave.mean(), out += 0.05 * passed.mean();
        QVERIFY(std::abs(loss.held() - (in - out)) < 1e-13);
        QVERIFY(loss.lost() >= lost - 1e-15);
        lost = loss.lost();
    }
    QVERIFY(std::abs(out - in) < 1e-12);
    // steady motion passes unchanged
    loss.setMean(0.3);
    QVERIFY(std::abs(loss.pass(WaveCell::constant(0.3), 0.05).end() - 0.3) < 1e-15);
}

void TestDrillingMarch::aWaveLosesItsShareInARoundTrip() {
    const std::vector<double> widths{0.1};
    LossyLine line;
    line.begin(100, 0.1, 0.2, widths);
    // a wave of no mean at a free end: what is left of its deviation comes back
    double amplitude = 1;
    for (int trip = 0; trip < 3; ++trip) {
        double energy = 0;
        for (int i = 0; i < 100; ++i) {
            const WaveCell out = line.arrive();
            energy += out.meanSquare();
            line.enter(trip == 0 ? WaveCell::constant(i % 2 ? 1 : -1) : out, out, 0);
            QVERIFY(line.lost() >= 0);
        }
        if (trip > 0)
            QVERIFY2(std::abs(std::sqrt(energy / 100) / amplitude - 0.8) < 2e-3,
                     qPrintable(QString::number(std::sqrt(energy / 100) / amplitude)));
        if (trip > 0) amplitude *= 0.8;
    }
}

/// Away from the rock a rod under a constant force takes steps of its own; where its waves are kept it does
/// not.
void TestDrillingMarch::flightIsTheSameWaveTurned() {
    for (const double loss : {0.0, 0.2}) {
        DrillingProblem problem = caseB(2, 0);
        problem.machine.reset();
        problem.waveLosses = {loss};
        const DrillingGrid grid = drillingGridOf(problem, 40);
        DrillingMarch quick(problem, grid), watched(problem, grid), kept(problem, grid);
        DrillingSamples samples;
        watched.watch(&samples);
        for (int blow = 0; blow < 4; ++blow) {
            QVERIFY(quick.takeBlow({}) && watched.takeBlow({}));
            QCOMPARE(watched.blow().gap, quick.blow().gap);  // who watches changes nothing
        }
        QVERIFY(kept.takeBlow({}) && kept.takeBlow({}));
        QVERIFY(kept.takeBlowWithWaves({}).waves);  // two blows
        const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-12 * (1 + std::abs(b)); };
        QCOMPARE(kept.blows(), quick.blows());
        QVERIFY(isNear(quick.blow().gap, kept.blow().gap));
        QVERIFY(isNear(quick.blow().velocity, kept.blow().velocity));
        QVERIFY(isNear(quick.blow().rockImpulse, kept.blow().rockImpulse));
        QVERIFY(isNear(quick.ledger().waves, kept.ledger().waves));
        QVERIFY(isNear(quick.ledger().feed, kept.ledger().feed));
        QVERIFY(isNear(quick.ledger().stored, kept.ledger().stored));
        QVERIFY(std::ranges::any_of(samples.bit, [](const BitSample& sample) { return sample.force == 0; }));
    }
}

void TestDrillingMarch::withoutBlowsTheRockCarriesTheFeed() {
    DrillingProblem problem = caseB(2, 0.5);
    PulseForce force = pulseForceOf(PulseShape::rectangular);
    for (PulseSegment& segment : force.segments) segment.value *= 1e-9;
    problem.blow.drive = force;
    problem.isFresh = false;
    problem.blow.law.gamma = 1;
    const double pressing = problem.feedForce;  // nothing pushes the machine back
    const Marched marched = march(problem, 20, 300);
    const DrillingBlow& last = marched.blows.back();
    QCOMPARE(last.contacts, 0.0);
    QVERIFY(last.gap == 0);
    QVERIFY(std::abs(last.rockImpulse / problem.interval - pressing) < 1e-6 * pressing + 1e-8);
    QVERIFY(std::abs(last.penetration) < 1e-12);
}

void TestDrillingMarch::theSameCraterIsShakenDown() {
    DrillingProblem problem = caseB(2, 0.15);
    problem.isFresh = false;
    const Marched marched = march(problem, 40, 60);
    double largest = 0;
    for (std::size_t i = 0; i < marched.blows.size(); ++i) {
        QVERIFY(marched.blows[i].penetration >= 0);
        if (marched.blows[i].penetration == 0) QVERIFY(marched.blows[i].peakForce <= largest);
        largest = std::max(largest, marched.blows[i].peakForce);
    }
    QCOMPARE(marched.blows.back().penetration, 0.0);
    QVERIFY(marched.blows.back().peakForce > 0);
}

/// Twice the blow, twice the feed and twice the gap: bit for bit.
void TestDrillingMarch::forcesGapsAndImpulsesScaleTogether() {
    DrillingProblem problem = caseB(1.3, 0.15);
    problem.blow.gap = 0.25;
    const Marched one = march(problem, 20, 40);
    PulseForce force = pulseForceOf(PulseShape::rectangular);
    for (PulseSegment& segment : force.segments) segment.value *= 2, segment.slope *= 2;
    force.peak *= 2;
    problem.blow.drive = force;
    problem.blow.gap *= 2;
    problem.feedForce *= 2;
    // in the unit of the doubled impulse the reaction is 2 f: only the unit is not scaled
    DrillingProblem scaled = problem;
    scaled.feedForce = problem.feedForce - 1 / drillingGridOf(problem, 20).interval();
    const Marched two = march(scaled, 20, 1);
    QVERIFY(std::abs(two.blows[0].peakForce - 2 * one.blows[0].peakForce) < 1e-12);
    QVERIFY(std::abs(two.blows[0].penetration - 2 * one.blows[0].penetration) < 1e-12);
}

void TestDrillingMarch::intervalsScatterAsTheSeedSays() {
    DrillingProblem problem = caseB(1.6, 0.15);
    problem.intervalScatter = 0.02;
    const Marched one = march(problem, 20, 200), again = march(problem, 20, 200);
    problem.seed = 2;
    const Marched other = march(problem, 20, 200);
    double square = 0;
    for (std::size_t i = 0; i + 1 < one.blows.size(); ++i) {
        QVERIFY(one.blows[i] == again.blows[i] || std::isnan(one.blows[i].hammerRebound));
        QCOMPARE(one.blows[i].gap, again.blows[i].gap);
        const double off = (one.blows[i + 1].time - one.blows[i].time) / problem.interval - 1;
        QVERIFY(std::abs(off) < 0.0601);
        square += off * off;
    }
    QVERIFY(std::abs(std::sqrt(square / 199) - 0.02) < 0.004);
    QVERIFY(one.blows[100].gap != other.blows[100].gap);
}

QTEST_GUILESS_MAIN(TestDrillingMarch)
#include "tst_drilling_march.moc"
