// SPDX-License-Identifier: GPL-3.0-or-later
// Blows on drill strings against reference solutions, the uniform rod and their own balances.
#include <QTest>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

#include "core/blow/impact_summary.h"
#include "core/contact/contact_law.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/network/network_march.h"
#include "core/wave/network/network_solver.h"
#include "core/wave/network/string_waves.h"
#include "tests/support/network_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// The string that is a uniform rod: a hammer of its impedance that is withdrawn after its blow.
Problem uniformRod(const Groups& groups) {
    Problem problem = struck();
    problem.sections = {{.impedance = 1, .transitTime = 0.5}, {.impedance = 1, .transitTime = groups.tau}};
    hammerOf(problem).face.restrike = false;
    problem.law = {groups.beta, groups.gamma};
    problem.gap = groups.delta;  // d0 = 2 I0/Z = v0 t0
    return problem;
}

double perHammerMomentum(double momentum, const Impact& impact) {
    return momentum / impact.hammerImpulse;
}

double leastOf(const PiecewisePolynomial& force) {
    constexpr int steps = 8;
    double least = 0;
    for (const PiecewisePolynomial::Piece& piece : force.pieces())
        for (int k = 0; k <= steps; ++k)
            least = std::min(least, force.value(piece, piece.length * k / steps));
    return least;
}

Impact march(const Problem& problem, const CellGrid& grid, const NetworkWants& wants, long mostCells) {
    NetworkMarch march;
    march.plan(problem, grid, wants);
    return march.run(mostCells, {});
}

/// How often random strings are tried: a fifth of `all` by day.
int scenesOr(int all) {
    return tries("DRILLWAVE_NETWORK_SCENES", all / 5, all);
}

}  // namespace

class TestNetworkSolver : public QObject {
    Q_OBJECT

  private slots:
    void referenceCases_data() {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const NetworkCase& scene : networkCases()) {
            if (isChosen(number, 5)) QTest::newRow(scene.id.c_str()) << number;
            ++number;
        }
        QCOMPARE(number, 30);
    }

    void referenceCases() {
        QFETCH(int, number);
        const NetworkCase scene = networkCases().at(std::size_t(number));
        NetworkSettings settings;
        settings.wants.forces = true;
        const Impact impact = solveNetwork(scene.problem, settings);
        QCOMPARE(impact.outcome, Outcome::endTime);
        const NetworkUnits& unit = scene.units;
        const double energy = impact.hammerWork * unit.energy();
        const double momentum = impact.hammerImpulse * unit.momentum();
        const double end = *scene.problem.endTime * unit.time;
        int compared = 0;
        // a value and what its digits are relative to; 0: to itself
        const auto compare = [&](const char* name, double value, double scale) {
            const QJsonObject expected = scene.reference[name].toObject();
            if (!expected["value"].isDouble() || expected["digits"].toInt() < 3) return;
            const double reference = expected["value"].toDouble();
            const double tolerance = std::pow(10, -std::min(expected["digits"].toInt(), 9));
            const double relative = scale > 0 ? scale : std::abs(reference);
            QVERIFY2(std::abs(value - reference) <= tolerance * relative + 1e-300,
                     QString("%1 = %2, not %3")
                         .arg(name)
                         .arg(value, 0, 'g', 15)
                         .arg(reference, 0, 'g', 15)
                         .toUtf8());
            ++compared;
        };
        compare("efficiency", impact.efficiency(), 1);
        compare("rock_work", impact.efficiency() * energy, energy);
        compare("rock_impulse", impact.impulse * unit.momentum(), momentum);
        compare("peak_rock_force", impact.peakForce * unit.force(), 0);
        const ImpactSummary summary = summarize(impact, scene.problem);
        const double v0 = scene.problem.velocity() * unit.velocity;
        compare("residual_penetration", summary.residualPenetration / lawUnitOfPenetration * unit.length(),
                0);
        compare("hammer_rebound_velocity", summary.hammerReboundVelocity * v0, unit.velocity);
        compare("hammer_final_energy", (impact.hammerEnergy / impact.hammerWork) * energy, energy);
        compare("string_momentum", impact.finalMomentum * unit.momentum(), momentum);
        compare("string_energy", (impact.finalEnergy / impact.hammerWork) * energy, energy);
        compare("first_rock_contact", impact.firstContactTime * unit.time, end);
        compare("last_rock_separation", impact.separationTime * unit.time, end);
        compare("time_peak_rock_force", impact.peakTime * unit.time, end);
        compare("piston_first_separation", impact.faceSeparation * unit.time, end);
        QVERIFY(compared >= 7);
        const double stated =
            std::abs(impact.efficiency() - scene.reference["efficiency"].toObject()["value"].toDouble());
        QVERIFY2(stated <= impact.efficiencyError + 1e-12, QByteArray::number(stated));
    }

    /// The reference takes all of the time until the end, and the ends of its pieces: what is greatest inside
    /// one it misses by up to 2e-4. It counts waves as they entered a section, which is more than what is
    /// left of them where they decay. Later than a round trip after the blow the waves still have its peaks,
    /// at the places that are looked up.
    void largestStressesOfReferenceCases() {
        int compared = 0, later = 0;
        for (const NetworkCase& scene : networkCases()) {
            const QJsonArray tension = scene.reference["peak_tension_stress"].toObject()["value"].toArray();
            const QJsonArray compression =
                scene.reference["peak_compression_stress"].toObject()["value"].toArray();
            if (tension.isEmpty()) continue;
            const Impact impact = solvedWithWaves(scene.problem);
            Impact whole = impact;
            whole.forcesEnd = std::numeric_limits<double>::infinity();
            whole.sections.clear();
            const std::vector<SectionEnvelope> envelope = stringEnvelope(whole, {}, {.leastOfSection = 400});
            for (std::size_t j = 0; j < impact.sections.size(); ++j) {
                const double kept = std::exp(-scene.problem.sections[j].decay);
                const double toStress = scene.units.force() / scene.areas[j];
                const SectionForces& forces = impact.sections[j];
                for (const auto& [during, after, reference] :
                     {std::tuple(&SectionForces::tension, &SectionForces::tensionAfter,
                                 tension[int(j)].toDouble()),
                      {&SectionForces::compression, &SectionForces::compressionAfter,
                       compression[int(j)].toDouble()}}) {
                    const double value = std::max((forces.*during).force, (forces.*after).force) * toStress;
                    ++compared;
                    QVERIFY2(value <= reference * (1 + 3e-4) + 1, scene.id.c_str());
                    if (value >= reference * kept * (1 - 2e-5) - 1) continue;
                    ++later;
                    const auto most = std::ranges::max(
                        envelope[j], {}, [&](const SectionForces& place) { return (place.*after).force; });
                    QVERIFY2((most.*after).time > impact.forcesEnd, scene.id.c_str());
                    const double share = (most.*after).force * toStress / (reference * kept);
                    QVERIFY2(share > 0.97, QByteArray::number(share));
                }
            }
        }
        QVERIFY(compared > 250);
        QVERIFY2(later > 0 && later < compared / 10, QByteArray::number(later));
    }

    /// The waves themselves, looked up at many places: none has more in either span of time, and they have it
    /// at the places of the largest ones.
    void stressesAreKeptApartWhereTheBlowEnds() {
        const auto kinds = {&SectionForces::compression, &SectionForces::tension,
                            &SectionForces::compressionAfter, &SectionForces::tensionAfter};
        constexpr double bend = 2e-3;  // a wave may bend within a cell of the quicker run, which keeps them
        int compared = 0, larger = 0;
        for (const char* id : {"t38_medium", "t38_gap", "t38_hard", "near_commensurate"}) {
            Problem problem = caseCalled(id).problem;
            problem.endTime = {};
            const Impact impact = solvedWithWaves(problem);
            const double transit = problem.transitTime(), end = impact.endOfBlow;
            QVERIFY(std::abs(end - impact.separationTime - transit) < 1e-9);
            QVERIFY(std::abs(impact.forcesEnd - end - 2 * transit) < 1e-9);
            for (std::size_t j = 0; j < impact.sections.size(); ++j) {
                const SectionForces& told = impact.sections[j];
                QVERIFY(std::max(told.tension.time, told.compression.time) <= end);
                QVERIFY(std::min(told.tensionAfter.time, told.compressionAfter.time) > end);
                for (const auto kind : kinds) {
                    const SectionPeak& peak = told.*kind;
                    for (int place = 0; place <= 20; ++place) {
                        const SectionPeak here =
                            largestForcesAt(*impact.waves, j, place / 20.0, end, impact.forcesEnd).*kind;
                        QVERIFY2(here.force <= peak.force * (1 + bend) + 1e-6, id);
                    }
                    QVERIFY(peak.time <= impact.forcesEnd + 1e-9);
                    const double there =
                        (largestForcesAt(*impact.waves, j, peak.place, end, impact.forcesEnd).*kind).force;
                    QVERIFY2(there >= peak.force * (1 - bend) - 1e-6, id);
                    ++compared;
                }
                larger += told.tensionAfter.force > told.tension.force;
            }
        }
        QVERIFY(compared > 100 && larger > 3);
    }

    void stringOfOneRodIsTheUniformRod() {
        Chance chance(5);
        int compared = 0;
        for (int i = 0; i < 300; ++i) {
            const Groups groups{chance.logarithmic(0.05, 20),
                                chance.below(3) ? chance.logarithmic(0.05, 1) : 1,
                                0.5 * (2 + chance.below(20)), chance.below(2) ? 0 : chance.fraction()};
            const Impact exact = solve({PulseShape::rectangular, groups}, Detail::summary);
            Problem problem = uniformRod(groups);
            problem.endTime = exact.separationTime + 0.1;
            const Impact impact = solveNetwork(problem, {});
            QCOMPARE(impact.outcome, Outcome::endTime);
            if (exact.growth > 10) continue;
            ++compared;
            const double cor = perHammerMomentum(impact.impulse, impact) - 1;
            QVERIFY2(std::abs(cor - exact.cor) <= 1e-12 + exact.corError,
                     QString("beta %1 gamma %2 tau %3 delta %4: %5, not %6")
                         .arg(groups.beta)
                         .arg(groups.gamma)
                         .arg(groups.tau)
                         .arg(groups.delta)
                         .arg(cor, 0, 'g', 15)
                         .arg(exact.cor, 0, 'g', 15)
                         .toUtf8());
        }
        QVERIFY(compared > 200);
    }

    void splittingASectionChangesNothing() {
        const NetworkCase scene = networkCases().at(7);  // t38_medium
        Problem split = scene.problem;
        for (std::size_t j : {4u, 0u}) {
            UniformSection& section = split.sections[j];
            section.transitTime /= 2;
            split.sections.insert(split.sections.begin() + std::ptrdiff_t(j), section);
        }
        ++hammerOf(split).sections;
        NetworkSettings quick{.accuracy = NetworkAccuracy::quick, .wants = {}};
        const Impact whole = solveNetwork(scene.problem, quick), parts = solveNetwork(split, quick);
        QVERIFY(std::abs(whole.efficiency() - parts.efficiency()) < 1e-14);
        QVERIFY(std::abs(whole.hammerMomentum - parts.hammerMomentum) < 1e-13);
    }

    void balancesCloseAndErrorsCoverInRandomStrings() {
        Chance chance(11);
        const int scenes = scenesOr(80);
        int uncovered = 0, inexact = 0;
        for (int i = 0; i < scenes; ++i) {
            const Problem problem = randomNetwork(chance);
            NetworkSettings settings;
            settings.mostCells = 200'000'000;
            const Impact sure = solveNetwork(problem, settings);
            settings.accuracy = NetworkAccuracy::quick;
            const Impact quick = solveNetwork(problem, settings);
            const QByteArray number = "scene " + QByteArray::number(i);
            QVERIFY2(sure.outcome == Outcome::endTime, number + ": " + sure.reason.text().c_str());
            QVERIFY2(quick.outcome == Outcome::endTime, number + ": " + quick.reason.text().c_str());
            QVERIFY2(std::abs(sure.momentumResidual()) < 1e-10,
                     number + ' ' + QByteArray::number(sure.momentumResidual()));
            // sharp layers that small masses throw to and fro in a hammer are too many to be kept all
            inexact += !(std::abs(sure.energyResidual()) < 1e-6);
            QVERIFY2(sure.peakForce >= 0 && sure.efficiency() >= -1e-12 && sure.efficiency() <= 1, number);
            const double difference = std::abs(sure.efficiency() - quick.efficiency());
            uncovered += !(difference <= sure.efficiencyError + quick.efficiencyError);
        }
        QVERIFY2(inexact <= scenes / 50, QByteArray::number(inexact));
        QVERIFY2(uncovered <= scenes / 100, QByteArray::number(uncovered));
    }

    /// As a uniform rod, whose e and work on the rock are known to all digits.
    void statedErrorsCoverUniformRods() {
        Chance chance(23);
        const int scenes = scenesOr(300);
        int compared = 0;
        for (int i = 0; i < scenes; ++i) {
            Groups groups{chance.logarithmic(0.05, 100), 1,
                          std::array{0.5, 1.0, 2.5, 5.0, 7.25}[chance.below(5)],
                          chance.oneIn(2) ? 0 : chance.fraction()};
            if (chance.oneIn(2)) groups.gamma = chance.logarithmic(0.05, 1);
            const Scene scene{PulseShape::rectangular, groups};
            const Impact rod = solve(scene, Detail::ledger);
            QCOMPARE(rod.outcome, Outcome::rebounded);
            for (const NetworkAccuracy accuracy : {NetworkAccuracy::quick, NetworkAccuracy::sure}) {
                const Impact impact = solveNetwork(uniformRod(groups), {.accuracy = accuracy, .wants = {}});
                QCOMPARE(impact.outcome, Outcome::rebounded);
                const std::string words = describe(scene) + ": ";
                const double ofCor = std::abs(-impact.finalMomentum / impact.faceImpulse - rod.cor);
                QVERIFY2(ofCor <= impact.corError + rod.corError,
                         (words + formatNumber(ofCor) + " of " + formatNumber(impact.corError)).c_str());
                const double kept = rod.rockWork / rod.hammerWork;
                const double ofEfficiency = std::abs(impact.efficiency() - kept);
                QVERIFY2(ofEfficiency <= impact.efficiencyError,
                         (words + formatNumber(ofEfficiency) + " of efficiency").c_str());
                ++compared;
            }
        }
        QCOMPARE(compared, 2 * scenes);
    }

    void energyThatIsMadeOrGoneIsNoResult() {
        const Impact right = solveNetwork(uniformRod({0.5, 0.3, 5, 0}), {});
        QVERIFY(right.balances());
        for (const double missing : {-1e-5, 0.06, double(NAN)}) {
            Impact wrong = right;
            wrong.rockWork -= missing * wrong.hammerWork;
            QVERIFY(!wrong.balances());
        }
    }

    /// All is counted at a time that lies within cells of most waves.
    void balancesCloseWhereverABlowEnds() {
        Chance chance(5);
        const int scenes = scenesOr(120);
        std::array<int, 3> ends{};
        for (int i = 0; i < scenes; ++i) {
            Problem problem = randomNetwork(chance);
            if (chance.below(3) != 0) problem.nextBlow = std::exchange(problem.endTime, {});
            for (const NetworkAccuracy accuracy : {NetworkAccuracy::quick, NetworkAccuracy::sure}) {
                if (accuracy == NetworkAccuracy::sure && i % 4 != 0) continue;
                const Impact impact = solveNetwork(problem, {.accuracy = accuracy, .wants = {}});
                const QByteArray number = "scene " + QByteArray::number(i);
                QVERIFY2(impact.outcome != Outcome::notSolved, number + ": " + impact.reason.text().c_str());
                ++ends[std::size_t(impact.outcome)];
                // at most to the next blow, and to that itself where bit or hammer may still meet again
                if (problem.nextBlow) QVERIFY2(impact.endTime <= *problem.nextBlow, number);
                if (impact.outcome == Outcome::nextBlow) QCOMPARE(impact.endTime, *problem.nextBlow);
                constexpr double closed = 1e-11;
                QVERIFY2(std::abs(impact.momentumResidual()) < closed,
                         number + " misses " + QByteArray::number(impact.momentumResidual()));
                const double given = impact.hammerImpulse - impact.hammerMomentum - impact.faceImpulse;
                QVERIFY2(std::abs(given) < closed * impact.hammerImpulse,
                         number + ": of the hammer " + QByteArray::number(given));
                // what cells do not resolve is lost, none is made, and the stated error knows
                QVERIFY2(impact.energyResidual() > -closed,
                         number + QByteArray::number(impact.energyResidual()));
                QVERIFY2(impact.efficiencyError >= std::abs(impact.energyResidual()), number);
                QVERIFY2(impact.peakForce >= 0 && impact.efficiency() >= 0, number);
            }
        }
        for (const int count : ends) QVERIFY2(count > scenes / 10, QByteArray::number(count));
    }

    void rockAndHammerPushAndNeverPull() {
        Chance chance(6);
        int looked = 0;
        for (int i = 0; i < 20; ++i) {
            Problem problem = randomNetwork(chance);
            problem.endTime = 10;  // most are short enough for all cells of a sure run to be kept
            NetworkSettings settings;
            settings.wants.histories = true;
            const Impact impact = solveNetwork(problem, settings);
            QCOMPARE(impact.outcome, Outcome::endTime);
            if (!impact.waves) continue;
            settings.accuracy = NetworkAccuracy::quick;
            const Impact quick = solveNetwork(problem, settings);
            if (impact.waves->clocks().size() <= quick.waves->clocks().size()) continue;  // they are the same
            ++looked;
            for (const PiecewisePolynomial* force : {&impact.waves->bitForce(), &impact.waves->faceForce()})
                QVERIFY2(leastOf(*force) > -1e-6,
                         QByteArray::number(i) + QByteArray::number(leastOf(*force)));
        }
        QVERIFY2(looked > 8, QByteArray::number(looked));
    }

    void nothingFollowsWhatIsProvenToBeOver() {
        Problem problem = networkCases().at(7).problem;
        problem.endTime.reset();
        const Impact proven = solveNetwork(problem, {.accuracy = NetworkAccuracy::quick, .wants = {}});
        QCOMPARE(proven.outcome, Outcome::rebounded);
        problem.endTime = 4 * proven.endTime;
        const Impact later = solveNetwork(problem, {.accuracy = NetworkAccuracy::quick, .wants = {}});
        QCOMPARE(later.contacts, proven.contacts);
        QVERIFY(std::abs(later.impulse - proven.impulse) < 1e-13);
        QVERIFY(std::abs(later.hammerMomentum - proven.hammerMomentum) < 1e-9);
    }

    /// Where only sums are wanted, the flight at the end is computed by means of cells: it ends at the same
    /// time with the same sums, for far less work.
    void aFreeFlightEndsLikeAFullMarch() {
        Chance chance(31);
        int flown = 0, proven = 0;
        constexpr int scenes = 60;
        for (int i = 0; i < scenes; ++i) {
            Problem problem = randomNetwork(chance);
            problem.endTime.reset();
            for (UniformSection& section : problem.sections)
                section.loss = section.decay = section.massAfter = 0;
            NetworkSettings settings{.accuracy = NetworkAccuracy::quick, .wants = {}};
            const Impact quick = solveNetwork(problem, settings);
            settings.wants.forces = true;  // these are found wherever the waves go
            const Impact full = solveNetwork(problem, settings);
            const QByteArray number = QByteArray::number(i);
            QVERIFY2(quick.outcome != Outcome::notSolved, number + quick.reason.text().c_str());
            QCOMPARE(quick.outcome, full.outcome);
            QVERIFY2(std::abs(quick.endTime - full.endTime) <= 1e-9 * full.endTime, number);
            QVERIFY2(std::abs(quick.efficiency() - full.efficiency()) < 1e-13, number);
            QVERIFY2(std::abs(quick.hammerMomentum - full.hammerMomentum) < 1e-13, number);
            QCOMPARE(quick.contacts, full.contacts);
            flown += quick.pieces < full.pieces;
            proven += quick.outcome == Outcome::rebounded;
        }
        QVERIFY2(flown > scenes / 2, QByteArray::number(flown));
        QVERIFY2(proven > scenes / 2, QByteArray::number(proven));
    }

    /// Half of the T38 blow is the proof that nothing follows.
    void theT38StringTakesAsManyCellsAsItIsInContact() {
        Problem problem = networkCases().at(7).problem;
        problem.endTime.reset();
        const Impact impact = solveNetwork(problem, {.accuracy = NetworkAccuracy::quick, .wants = {}});
        const double steps = (impact.separationTime + 10) / impact.cell;
        const double nodes = double(problem.sections.size() + 1);
        QVERIFY2(double(impact.pieces) < steps * nodes, QByteArray::number(double(impact.pieces)));
    }

    /// Counts from the time on the rock say nothing of a bit that has left it since.
    void aBlowDoesNotEndWithTheCountOfAContact() {
        Chance chance(1);
        Problem problem = struck();
        for (int i = 0; i < 15; ++i) problem = randomNetwork(chance);
        problem.endTime.reset();
        for (UniformSection& section : problem.sections) section.loss = section.decay = 0;
        NetworkSettings settings{.accuracy = NetworkAccuracy::quick, .wants = {}};
        settings.wants.events = true;
        const Impact impact = solveNetwork(problem, settings);
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QCOMPARE(impact.events.back().time, impact.separationTime);
    }

    void whatIsStoppedTakesNoStep() {
        std::stop_source source;
        source.request_stop();
        for (const bool forces : {false, true}) {
            NetworkSettings settings;
            settings.wants.forces = forces;
            const Impact impact = solveNetwork(networkCases().at(7).problem, settings, source.get_token());
            QCOMPARE(impact.outcome, Outcome::notSolved);
            QCOMPARE(impact.reason.text(), std::string("stopped"));
            QVERIFY(impact.pieces <= 64 * 12);
        }
    }

    void cutsThatCannotBeFollowedToTheEndAreNotMade() {
        const Problem problem = networkCases().at(7).problem;
        NetworkWants wants;
        wants.cutAt = CutAt::corners;
        wants.grading = {0.15, 1.25, 100};
        CellGrid grid;
        QVERIFY(usualGrid(problem, grid));
        const Impact all = march(problem, grid, wants, mostNetworkCells);
        const long permitted = all.pieces / 2;
        const Impact some = march(problem, grid, wants, permitted);
        QCOMPARE(some.outcome, Outcome::endTime);
        QVERIFY(some.pieces <= permitted);
        QVERIFY(std::abs(some.efficiency() - all.efficiency()) < 1e-9);
    }

    void whatTakesTooMuchWorkSaysWhatTookIt() {
        Problem problem = networkCases().at(7).problem;
        CellGrid grid;
        QVERIFY(usualGrid(problem, grid));
        const Impact whole = march(problem, grid, {}, mostNetworkCells);
        const Impact half = march(problem, grid, {}, whole.pieces / 2);
        QCOMPARE(half.outcome, Outcome::notSolved);
        QVERIFY(half.reason.text().starts_with("it takes more computing steps than the work limit permits"));
        problem.sections.back().massAfter = 1e-6;  // which swings through many thousand pieces
        const Impact swinging = march(problem, grid, {}, 2 * whole.pieces);
        QCOMPARE(swinging.outcome, Outcome::notSolved);
        QVERIFY2(swinging.reason.text().find("oscillates too fast") != std::string::npos,
                 swinging.reason.text().c_str());
    }

    void theLargestForcesAreLeftOutRatherThanTheBlow() {
        const Problem problem = networkCases().at(7).problem;
        CellGrid grid;
        QVERIFY(usualGrid(problem, grid));
        NetworkWants wants;
        const Impact sums = march(problem, grid, wants, mostNetworkCells);
        const long permitted = 2 * sums.pieces;
        wants.forces = true;
        QCOMPARE(march(problem, grid, wants, permitted).outcome, Outcome::notSolved);
        wants.forcesIfTheyFit = true;
        const Impact without = march(problem, grid, wants, permitted);
        QCOMPARE(without.outcome, Outcome::endTime);
        QVERIFY(without.leftOutForces && without.sections.empty() && without.jointReflection.empty());
        QCOMPARE(without.efficiency(), sums.efficiency());
        const Impact with = march(problem, grid, wants, mostNetworkCells);
        QVERIFY(!with.leftOutForces && with.sections.size() == problem.sections.size());
    }

    void lossesInsideTheHammerAreRefused() {
        Problem problem = networkCases().at(7).problem;
        problem.sections[0].loss = 0.01;
        const Impact impact = solveNetwork(problem, {});
        QCOMPARE(impact.outcome, Outcome::notSolved);
        QVERIFY(!impact.reason.isEmpty());
    }

    void lengthsThatShareNoCellAreRoundedWithAnError() {
        Problem problem = networkCases().at(7).problem;
        for (std::size_t j = 0; j < problem.sections.size(); ++j)
            problem.sections[j].transitTime *= 1 + 0.01 * std::sin(double(j * j + 1));
        const Impact impact = solveNetwork(problem, {});
        QCOMPARE(impact.outcome, Outcome::endTime);
        QVERIFY(impact.rounding > 0);
        QVERIFY2(impact.efficiencyError > 1e-7 && impact.efficiencyError < 0.05,
                 QByteArray::number(impact.efficiencyError));
    }
};

QTEST_GUILESS_MAIN(TestNetworkSolver)
#include "tst_network_solver.moc"
