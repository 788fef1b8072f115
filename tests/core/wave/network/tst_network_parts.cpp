// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the solver of drill strings: cells, relaxations, grids, and a lattice to compare with.
#include <QTest>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/network/network_solver.h"
#include "core/wave/network/plain_lattice.h"
#include "core/wave/network/relaxation.h"
#include "core/wave/network/section_watch.h"
#include "core/wave/network/wave_cell.h"
#include "tests/support/network_scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr std::size_t block = 64;

std::vector<NodeTurn> turnsOf(const std::vector<std::size_t>& delays) {
    std::vector<NodeTurn> turns;
    planTurns(delays, block, turns);
    return turns;
}

std::optional<CellGrid> grid(const std::vector<double>& lengths) {
    std::vector<UniformSection> sections;
    for (const double length : lengths) sections.push_back({.impedance = 1, .transitTime = length});
    CellGrid shared;
    return shareGrid(sections, 1e-6, shared) ? std::optional(shared) : std::nullopt;
}

}  // namespace

class TestNetworkParts : public QObject {
    Q_OBJECT

  private slots:
    void aPartOfACellIsTheSameWave() {
        const WaveCell f{{1, -0.7, 0.4, 0.3}};
        const WaveCell part = f.part(0.2, 0.6);
        for (const double u : {0.0, 0.3, 1.0})
            QVERIFY(std::abs(part.value(u) - f.value(0.2 + 0.4 * u)) < 1e-14);
        const double whole = 0.2 * f.part(0, 0.2).mean() + 0.4 * part.mean() + 0.4 * f.part(0.6, 1).mean();
        QVERIFY(std::abs(whole - f.mean()) < 1e-15);
    }

    void thePeakOfACellIsItsLargestValue() {
        Chance chance(3);
        for (int i = 0; i < 1000; ++i) {
            WaveCell f;
            for (double& c : f.c) c = chance.fraction() - 0.5;
            double largest = -10;
            for (int k = 0; k <= 1000; ++k) largest = std::max(largest, f.value(k / 1000.0));
            const WaveCell::Peak peak = f.peak();
            QVERIFY(peak.value >= largest - 1e-15 && peak.value <= largest + 1e-5);
            QVERIFY(std::abs(f.value(peak.place) - peak.value) < 1e-12);
        }
    }

    /// y' = a(q − y), q = 1: y = 1 + (y0 − 1) e^(−a u).
    void aRelaxationKeepsTheMomentsOfTheExponential() {
        for (const double rate : {1e-6, 0.1, 1.0, 7.0, 39.9, 40.1, 1e3, 1e9, 1e15}) {
            double y = 3;
            const WaveCell cell = Relaxation(rate).follow(WaveCell::constant(1), y);
            const double mean = 1 + 2 * -std::expm1(-rate) / rate;
            QVERIFY2(std::abs(cell.mean() - mean) < 1e-14 * 3, QByteArray::number(rate));
            QVERIFY2(std::abs(y - (1 + 2 * std::exp(-rate))) < 3e-14, QByteArray::number(rate));
            // ∫u e^(−a u) du
            const double first =
                rate < 1e-3 ? 0.5 - rate / 3 : (1 - std::exp(-rate) * (1 + rate)) / (rate * rate);
            QVERIFY2(std::abs(cell.firstMoment() - (0.5 + 2 * first)) < 1e-12, QByteArray::number(rate));
        }
    }

    void theCellIsTheLargestThatAllRoundTripsShare() {
        const auto millimetres = grid({0.300, 0.250, 0.450, 0.190, 3.660, 0.070, 0.060});
        QVERIFY(millimetres && std::abs(millimetres->cell - 0.020) < 1e-12);
        QCOMPARE(millimetres->roundTrips, (std::vector<long>{30, 25, 45, 19, 366, 7, 6}));
        QVERIFY(!grid({1, std::sqrt(2.0) / 1.3, M_PI / 3}));
    }

    /// The rounding of Euclid must not be carried from section to section: after two of them 4 mm would be
    /// 3.99999999998.
    void stringsOfWholeMillimetresShareACell() {
        const double steel = std::sqrt(210e9 / 7850);
        const auto share = [&](const std::vector<long>& millimetres) {
            std::vector<double> transits;
            const double hammer = 2e-3 * double(millimetres[0] + millimetres[1]) / steel;  // t0
            for (const long length : millimetres) transits.push_back(1e-3 * double(length) / steel / hammer);
            return grid(transits);
        };
        const auto held = share({364, 56, 334, 78, 5372, 78, 5372, 30, 64});
        QVERIFY(held);
        QCOMPARE(held->roundTrips, (std::vector<long>{182, 28, 167, 39, 2686, 39, 2686, 15, 32}));

        Chance chance(31);
        for (int i = 0; i < 9000; ++i) {
            const long unit = std::array{1, 2, 5, 10}[chance.below(4)];
            std::vector<long> lengths(4 + chance.below(9));
            for (long& length : lengths)
                length = unit * (1 + chance.below(chance.oneIn(3) ? 6000 : 600) / unit);
            long divisor = 0;
            for (const long length : lengths) divisor = std::gcd(divisor, length);
            const auto grid = share(lengths);
            QVERIFY2(grid, QByteArray::number(i));
            for (std::size_t j = 0; j < lengths.size(); ++j)
                QCOMPARE(grid->roundTrips[j], lengths[j] / divisor);
        }
    }

    void cutsStayInOrderAndGradedPartsFollowAFront() {
        CellCuts cuts(1, {1e4}, {0.3, 1.5, 24});
        const std::size_t parts = cuts.count();
        QVERIFY(parts > 10 && parts < 60);
        QVERIFY(cuts.widths().front() < 1e-4);
        QVERIFY(cuts.cutAt(0.37));
        QVERIFY(!cuts.cutAt(0.37));
        QVERIFY(cuts.count() > parts + 5);
        QVERIFY(std::is_sorted(cuts.places().begin(), cuts.places().end()));
        double sum = 0;
        for (const double width : cuts.widths()) sum += width;
        QVERIFY(std::abs(sum - 1) < 1e-12);
    }

    /// It shares nothing with the solver but the problem: both must come to the same.
    /// A node may take a step when the next one has taken that of a round trip before, and the one behind it
    /// the same step.
    void nodesTakeEveryStepOnceAndNoneTooEarly() {
        Chance chance(17);
        for (int scene = 0; scene < 200; ++scene) {
            std::vector<std::size_t> delays(1 + chance.below(12));
            for (std::size_t& delay : delays) delay = 1 + chance.below(scene % 2 ? 8 : 200);
            std::vector<std::size_t> taken(delays.size() + 1, 0);
            for (const NodeTurn& turn : turnsOf(delays)) {
                QCOMPARE(turn.from, taken[turn.node]);
                taken[turn.node] = turn.behind();
                if (turn.node > 0) QVERIFY(taken[turn.node - 1] >= turn.behind());
                if (turn.node < delays.size())
                    QVERIFY(turn.behind() <= taken[turn.node + 1] + delays[turn.node]);
            }
            for (const std::size_t steps : taken) QCOMPARE(steps, block);
        }
    }

    void longSectionsLetNodesTakeWholeBlocks() {
        QCOMPARE(turnsOf({64, 100, 365}).size(), std::size_t(4));
        // the bit and its neighbour take turns, the others do not wait for them
        QCOMPARE(turnsOf({365, 365, 32}).size(), std::size_t(2 + 2 * 2));
    }

    void theLargestOfAWindowIsFoundWithFewLooks() {
        Chance chance(21);
        WindowMaxima maxima;
        std::vector<double> values;
        constexpr long window = 50'000, steps = 60'000;
        maxima.begin(window);
        long looked = 0, told = 0;
        for (long step = 0; step < steps; ++step) {
            const long oldest = std::max(0L, step - window);
            maxima.dropBefore(oldest);
            values.push_back(chance.fraction());
            maxima.push(step - 100, values.back());  // steps below zero are those before the blow
            if (step % 1000) continue;
            double largest = 0;
            looked += maxima.search(
                oldest - 100, step - 99, [&](double most, long, long) { return most > largest; },
                [&](long at) {
                    ++told;
                    largest = std::max(largest, values[std::size_t(at + 100)]);
                });
            QCOMPARE(largest, *std::max_element(values.begin() + oldest, values.end()));
        }
        QVERIFY2(looked < 60 * 200, QByteArray::number(double(looked)));
        QVERIFY2(told < 60 * 20 * WindowMaxima::smallest, QByteArray::number(double(told)));
    }

    /// The largest force of a section that loses on its way is among all pairs of cells that meet in it.
    void theLargestForceOfALongLossySectionTakesFewLooks() {
        constexpr long cells = 20'000, steps = 25'000;
        const double width = 1.0 / cells, decay = 0.7;
        Chance chance(23);
        const CellCuts cuts(width, {}, {0.3, 1.5, 24});
        std::vector<WaveCell> ups(cells, WaveCell::constant(0)), downs;
        SectionWatch watch({.transitTime = 0.5, .decay = decay, .startTime = 0});
        watch.restart(ups, 0);
        for (long step = 0; step < steps; ++step) {
            const double slow = std::sin(0.001 * double(step)) + 0.1 * chance.fraction();
            downs.push_back(WaveCell::constant(slow));
            ups.push_back(WaveCell::constant(0.8 * slow - 0.3));
            watch.add({&downs.back(), 1}, {ups.data() + step, std::size_t(cells) + 1}, step, cuts, 1e9);
        }
        double most = 0;
        for (long step = 0; step < steps; step += 7)
            for (long back = 0; back <= cells; back += 3) {
                const double share = double(back) / cells;
                most = std::max(most,
                                downs[std::size_t(step)].mean() * std::exp(-decay * (1 - share)) +
                                    ups[std::size_t(cells + step - back)].mean() * std::exp(-decay * share));
            }
        const double told = watch.forces().compression.force;
        QVERIFY2(told >= most && told < most * 1.01, QByteArray::number(told / most, 'g', 12));
        QVERIFY2(watch.looked() < 100 * steps, QByteArray::number(double(watch.looked()) / steps));
    }

    /// Waves that die away: what comes later is ruled out by blocks, and what is largest is found all the
    /// same.
    void theLargestForceOfALosslessSectionIsLookedForInFewCells() {
        constexpr std::size_t window = 300, steps = 64 * 100;
        Chance chance(29);
        const CellCuts cuts(1.0 / window, {}, {0.3, 1.5, 24});
        const auto cell = [&](std::size_t step) {
            const double size = std::exp(-1e-3 * double(step));
            return WaveCell{{size * std::sin(0.02 * double(step)), 0.1 * size * chance.fraction(),
                             0.05 * size * chance.fraction(), 0.02 * size * chance.fraction()}};
        };
        std::vector<WaveCell> ups(window, WaveCell::constant(0)), downs;
        for (std::size_t step = 0; step < steps; ++step)
            downs.push_back(cell(step)), ups.push_back(cell(step + 70));
        SectionWatch watch({.transitTime = 0.5, .decay = 0, .startTime = 0});
        watch.restart({ups.data(), window}, 0);
        for (std::size_t step = 0; step < steps; step += block)
            watch.add({downs.data() + step, block}, {ups.data() + step, window + block}, long(step), cuts,
                      1e9);
        for (const double sign : {1.0, -1.0}) {
            double most = 0;  // of cells that f meets as a whole
            for (std::size_t step = 0; step < steps; ++step)
                for (std::size_t at = step + 1; at < step + window; ++at)
                    most = std::max(most, (sign * downs[step]).peak().value + (sign * ups[at]).peak().value);
            const SectionForces forces = watch.forces();
            const double told = (sign > 0 ? forces.compression : forces.tension).force;
            QVERIFY2(told == most, QByteArray::number(told - most));
        }
        QVERIFY2(watch.cellsLookedInto() < long(steps) / 5,
                 QByteArray::number(double(watch.cellsLookedInto())));
    }

    /// Includes a whole blow.
    void theLargestForcesOfTheT38StringAreLookedForInFewCells() {
        NetworkSettings settings{.accuracy = NetworkAccuracy::quick, .wants = {}};
        settings.wants.forces = true;
        const Impact impact = solveNetwork(networkCases().at(7).problem, settings);
        QVERIFY(!impact.sections.empty());
        QVERIFY(impact.cellsLookedInto > 0);
        QVERIFY2(impact.cellsLookedInto < impact.pieces / 5,
                 QByteArray::number(double(impact.cellsLookedInto) / double(impact.pieces)));
    }

    void whatJointsReflectIsFoundWhereItIsWanted() {
        NetworkSettings settings{.accuracy = NetworkAccuracy::quick, .wants = {}};
        settings.wants.forces = true;
        QVERIFY(solveNetwork(networkCases().at(7).problem, settings).jointReflection.empty());
        settings.wants.reflections = true;
        QVERIFY(!solveNetwork(networkCases().at(7).problem, settings).jointReflection.empty());
    }

    void thePlainLatticeComesToTheReferenceToo() {
        int compared = 0;
        for (const NetworkCase& scene : networkCases()) {
            if (scene.id.find("stiff") != std::string::npos) continue;  // needs cells that no lattice has
            CellGrid grid;
            QVERIFY(usualGrid(scene.problem, grid));
            while (*scene.problem.endTime / grid.cell < 30'000) grid.halve();
            const PlainBlow blow = solvePlainLattice(scene.problem, grid);
            QVERIFY(blow.isSolved);
            const double expected = scene.reference["efficiency"].toObject()["value"].toDouble();
            QVERIFY2(std::abs(blow.efficiency - expected) < 3e-3,
                     QByteArray(scene.id.c_str()) + ' ' + QByteArray::number(blow.efficiency - expected));
            ++compared;
        }
        QVERIFY(compared >= 24);
    }
};

QTEST_GUILESS_MAIN(TestNetworkParts)
#include "tst_network_parts.moc"
