// SPDX-License-Identifier: GPL-3.0-or-later
// Strings with cones, for which uniform pieces stand.
#include <QTest>

#include <cmath>

#include "core/blow/blow.h"
#include "core/blow/blow_waves.h"
#include "core/blow/chain_solution.h"
#include "core/blow/string_blow.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scene.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// A long force on one cone of 2 m, far from the rock.
constexpr const char* coneAlone = R"(drillwave: 2
pulse: {shape: rectangular, duration: 1 ms, force: 100 kN}
string:
  - {name: rod, length: 2 m, diameter: 40 mm, end_diameter: 80 mm}
end_time: 0.38 ms
bit_rock: {stiffness: 100 MN/m, gamma: 0.1, gap: 1 m}
)";

Scenario scenarioOf(std::string_view text) {
    return parseScenario(std::string(text), "test").scenario;
}

Scenario example(std::string_view name) {
    return parseScenario(findExample(name)->text, std::string(name)).scenario;
}

Impact solvedWaves(const Scenario& scenario, int pieces) {
    NetworkSettings settings;
    settings.wants.histories = true;
    return solveNetwork(problemOf(scenario, {pieces}), settings);
}

/// Waves in a cone are spherical: behind the front of a constant force F on its end at the distance x0 from
/// the apex, −N/F = (x/x0) e^(−y) + 1 − e^(−y), y = (c t − x + x0)/x0. Its integral over time [s].
double sphericalImpulse(double share, double time) {
    constexpr double length = 2, rear = 0.04, front = 0.08, x0 = length * rear / (front - rear);
    const double x = x0 + share * length, c = std::sqrt(210e9 / 7850), y = (c * time - (x - x0)) / x0;
    return y < 0 ? 0 : x0 / c * (x / x0 * (1 - std::exp(-y)) + y - 1 + std::exp(-y));
}

double largestDifference(int pieces) {
    const Scenario scenario = scenarioOf(coneAlone);
    const Impact impact = solvedWaves(scenario, pieces);
    const double t0 = pulseDuration(scenario);
    double largest = 0;
    for (const double share : {0.125, 0.5, 0.75})
        for (const double behind : {0.02e-3, 0.08e-3}) {
            const double time = share * 2 / std::sqrt(210e9 / 7850) + behind;
            const double impulse =
                impact.waves->downImpulse(0, share, time / t0) + impact.waves->upImpulse(0, share, time / t0);
            largest = std::max(largest, std::abs(impulse * t0 / sphericalImpulse(share, time) - 1));
        }
    return largest;
}

/// The T38 string, two of its sections as cones.
Scenario randomCones(Chance& chance) {
    Scenario scenario = example(chance.oneIn(2) ? "t38_string" : "r32_string");
    const double end = 0.02 + 0.06 * chance.fraction(), other = 0.03 + 0.05 * chance.fraction();
    findParameter("string.1.end_diameter")->assign(scenario, end);
    findParameter(chance.oneIn(2) ? "hammer.1.end_diameter" : "string.2.end_diameter")
        ->assign(scenario, other);
    scenario.bitRock.stiffness = chance.logarithmic(2e7, 1e9);
    scenario.bitRock.gamma = chance.logarithmic(0.05, 1);
    return scenario;
}

}  // namespace

class TestChainSolution : public QObject {
    Q_OBJECT

  private slots:
    void wavesInAConeAreSpherical() {
        const double coarse = largestDifference(32), fine = largestDifference(128);
        QVERIFY2(fine < 1e-3, QByteArray::number(fine));
        QVERIFY2(fine < coarse / 10, QByteArray::number(coarse) + " " + QByteArray::number(fine));
    }

    void aConeThatDoesNotTaperIsTheSection() {
        Scenario scenario = example("t38_string");
        const Blow plain = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
        findParameter("string.1.end_diameter")->assign(scenario, 0.045);
        const Blow blow = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
        QCOMPARE(blow.summary.cor, plain.summary.cor);
        QCOMPARE(blow.summary.energy.rockWork, plain.summary.energy.rockWork);
    }

    // A step of the T38 string, spread out over its adapter, throws back less.
    void aConeThrowsBackLessThanAStep() {
        Scenario scenario = example("t38_string");
        const double step = solveBlow(scenario, {}, Detail::ledger).summary.energy.rockWork;
        findParameter("string.1.diameter")->assign(scenario, 0.038);
        findParameter("string.1.end_diameter")->assign(scenario, 0.056);
        QVERIFY(solveBlow(scenario, {}, Detail::ledger).summary.energy.rockWork > step);
    }

    void statedErrorsCoverWhatPiecesMake() {
        Chance chance(2411);
        NetworkSolver solver;
        int looked = 0;
        const int scenes = tries("DRILLWAVE_CONE_SCENES", 3, 6);
        for (int i = 0; i < scenes; ++i) {
            const Scenario scenario = randomCones(chance);
            const QByteArray number = QByteArray::number(i);
            for (const auto accuracy : {NetworkAccuracy::quick, NetworkAccuracy::sure}) {
                const ChainSolution solution =
                    solveChain(scenario, {.accuracy = accuracy, .wants = {}}, solver);
                QVERIFY2(solution.impact.isSolved(), number + solution.impact.reason.text().c_str());
                QVERIFY2(std::abs(solution.impact.momentumResidual()) < 1e-9, number);
                std::vector<int> finer = solution.problem.pieces;
                for (int& count : finer)
                    if (count > 1) count *= 4;
                const Impact truth = solver.solve(problemOf(scenario, finer), {.wants = {}});
                if (!truth.isSolved() || truth.rounding > 1e-9) continue;  // more work than is permitted
                ++looked;
                QVERIFY2(std::abs(solution.impact.efficiency() - truth.efficiency()) <=
                             solution.impact.efficiencyError,
                         number);
                QVERIFY2(std::abs(solution.impact.cor - truth.cor) <= solution.impact.corError, number);
            }
        }
        QVERIFY2(looked > scenes / 2, QByteArray::number(looked));
    }

    void piecesStayOnCellsThatLengthsShare() {
        Scenario scenario = example("t38_string");
        findParameter("string.1.end_diameter")->assign(scenario, 0.06);
        NetworkSolver solver;
        const ChainSolution solution = solveChain(scenario, {}, solver);
        QCOMPARE(solution.problem.pieces.size(), allSections(scenario.drillString).size());
        QVERIFY(solution.problem.sections.size() > solution.problem.pieces.size() + 7);
        QVERIFY(solution.impact.rounding < 1e-9);
        QVERIFY(solution.impact.efficiencyError < 1e-4);
    }

    void resultsAreOfSectionsAndNotOfPieces() {
        Scenario scenario = example("t38_string");
        findParameter("string.1.end_diameter")->assign(scenario, 0.03);
        findParameter("hammer.1.end_diameter")->assign(scenario, 0.04);
        const Blow blow = solveBlow(scenario, {}, Detail::histories, {}, Stresses::wanted);
        const std::vector<const Section*> sections = allSections(scenario.drillString);
        const std::vector<SectionStress> stresses = sectionStresses(scenario, blow.impact);
        QCOMPARE(stresses.size(), sections.size());
        QCOMPARE(blow.impact.jointReflection.size(), sections.size() - 3);
        // the wave gets larger where the section gets thinner
        QVERIFY(stresses[2].compression.place > 0.8 * sections[2]->length);
        // and what the waves that were kept have at that place, of that cross-section, is it
        const StressPeak& peak = stresses[2].compression;
        const double share = peak.place / sections[2]->length;
        const double force =
            blow.impact.waves->force(2, share, peak.time / blow.scales.time, TimeSide::after);
        const double before =
            blow.impact.waves->force(2, share, peak.time / blow.scales.time, TimeSide::before);
        const double stress = std::max(force, before) * blow.scales.force / areaAt(*sections[2], share);
        QVERIFY2(std::abs(stress / peak.stress - 1) < 0.02, QByteArray::number(stress / peak.stress));
        // one field over all places
        const BlowWaves waves(blow);
        for (const double x : {-0.02, 0.001, 0.02, 0.03, 0.5})
            QVERIFY(std::isfinite(waves.value(WaveQuantity::force, x, waves.end() / 2)));
    }
};

QTEST_GUILESS_MAIN(TestChainSolution)
#include "tst_chain_solution.moc"
