// SPDX-License-Identifier: GPL-3.0-or-later
// Strings with cones, which are replaced by uniform pieces.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
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
#include "tests/support/lossless_string.h"
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

/// A bit that widens behind a joint with a large loss.
constexpr const char* coneBehindALoss = R"(drillwave: 2
hammer: {velocity: 10 m/s, sections: [{length: 400 mm, diameter: 60 mm}]}
string:
  - {length: 1600 mm, diameter: 57 mm}
  - {length: 160 mm, diameter: 65 mm, loss: 11 %}
  - {length: 40 mm, diameter: 128 mm, end_diameter: 191 mm}
end_time: 2 ms
bit_rock: {stiffness: 900 MN/m, gamma: 0.03}
)";

/// A hammer with a cone on a string whose lengths share a millimetre and no more.
constexpr const char* coneOfOddLengths = R"(drillwave: 2
hammer:
  velocity: 10 m/s
  restrike: false
  sections:
    - {length: 267 mm, diameter: 51 mm}
    - {length: 71 mm, diameter: 58 mm, end_diameter: 46 mm}
    - {length: 203 mm, diameter: 48 mm}
string:
  - {length: 464 mm, diameter: 45 mm, bore: 12 mm}
  - {length: 156 mm, diameter: 56 mm, bore: 14.5 mm}
  - {length: 2689 mm, diameter: 39 mm, bore: 14.5 mm}
  - {length: 129 mm, diameter: 56 mm, bore: 14.5 mm}
  - {length: 57 mm, diameter: 66 mm}
bit_rock: {stiffness: 269 MN/m, gamma: 0.1}
)";

Scenario scenarioOf(std::string_view text) {
    return parseScenario(std::string(text), "test").scenario;
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
    Scenario scenario = test::losslessString(chance.oneIn(2) ? "t38_string" : "r32_string");
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
        Scenario scenario = test::losslessString();
        const Blow plain = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
        findParameter("string.1.end_diameter")->assign(scenario, 0.045);
        const Blow blow = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
        QCOMPARE(blow.summary.cor, plain.summary.cor);
        QCOMPARE(blow.summary.energy.rockWork, plain.summary.energy.rockWork);
    }

    // A step of the T38 string, spread out over its adapter, reflects less.
    void aConeThrowsBackLessThanAStep() {
        Scenario scenario = test::losslessString();
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
                    if (count > 1) count *= 2;
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

    void errorsHoldAgainstAnotherProgram() {
        QFile file(QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/string_cones.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonArray cases = QJsonDocument::fromJson(file.readAll()).object()["cases"].toArray();
        QCOMPARE(cases.size(), 80);
        const int chosen = tries("DRILLWAVE_CONE_CASES", 20, 80);
        NetworkSolver solver;
        int cones = 0;
        for (int i = 0; i < cases.size(); ++i) {
            if (i % (80 / chosen) != 0) continue;
            const QJsonObject one = cases[i].toObject();
            const Scenario scenario = scenarioOf(one["scenario"].toString().toStdString());
            cones += !hasUniformSections(scenario.drillString);
            for (const auto accuracy : {NetworkAccuracy::quick, NetworkAccuracy::sure}) {
                const Impact impact =
                    solveChain(scenario, {.accuracy = accuracy, .wants = {}}, solver).impact;
                QVERIFY2(impact.isSolved(), qPrintable(one["id"].toString()));
                const auto agrees = [&](const char* key, double value, double error) {
                    const QJsonObject reference = one[key].toObject();
                    return std::abs(value - reference["value"].toDouble()) <=
                           error + reference["error"].toDouble();
                };
                QVERIFY2(agrees("efficiency", impact.efficiency(), impact.efficiencyError),
                         qPrintable(one["id"].toString()));
                QVERIFY2(agrees("cor", impact.cor, impact.corError), qPrintable(one["id"].toString()));
                QVERIFY2(impact.efficiencyError < 2e-3 || accuracy == NetworkAccuracy::quick,
                         QByteArray::number(impact.efficiencyError));
            }
        }
        QVERIFY(cones > chosen / 2);
    }

    // A bit that widens from 128 to 191 mm over 40 mm behind a joint that takes 11 % of the energy.
    void piecesBehindALossConvergeWithTheSquareOfTheirLength() {
        const Scenario scenario = scenarioOf(coneBehindALoss);
        const auto efficiency = [&](int pieces) {
            return solveNetwork(problemOf(scenario, {1, 1, 1, pieces}), {.wants = {}}).efficiency();
        };
        const double fine = efficiency(32), coarse = std::abs(efficiency(4) - fine);
        const double finer = std::abs(efficiency(8) - fine);
        QVERIFY2(coarse < 1e-3 && finer < 0.4 * coarse,
                 QByteArray::number(coarse) + " " + QByteArray::number(finer));
    }

    // Waves of many pieces may take too much work: then the numbers are those of fewer pieces, and agree.
    void wantedForcesDoNotSpoilTheNumbers() {
        const Scenario scenario = scenarioOf(coneOfOddLengths);
        NetworkSolver solver;
        const Impact sums = solveChain(scenario, {.wants = {}}, solver).impact;
        NetworkSettings withForces;
        withForces.wants.forces = withForces.wants.histories = true;
        const Impact impact = solveChain(scenario, withForces, solver).impact;
        QVERIFY(impact.isSolved() && !impact.sections.empty() && !impact.isRounded());
        const double difference = std::abs(impact.efficiency() - sums.efficiency());
        QVERIFY2(difference <= sums.efficiencyError + impact.efficiencyError, QByteArray::number(difference));
        QVERIFY2(impact.efficiencyError < 1e-3, QByteArray::number(impact.efficiencyError));
    }

    void piecesStayOnCellsThatLengthsShare() {
        Scenario scenario = test::losslessString();
        findParameter("string.1.end_diameter")->assign(scenario, 0.06);
        NetworkSolver solver;
        const ChainSolution solution = solveChain(scenario, {}, solver);
        QCOMPARE(solution.problem.pieces.size(), allSections(scenario.drillString).size());
        QVERIFY(solution.problem.sections.size() > solution.problem.pieces.size() + 7);
        QVERIFY(solution.impact.rounding < 1e-9);
        QVERIFY(solution.impact.efficiencyError < 1e-4);
    }

    void resultsAreOfSectionsAndNotOfPieces() {
        Scenario scenario = test::losslessString();
        findParameter("string.1.end_diameter")->assign(scenario, 0.03);
        findParameter("hammer.1.end_diameter")->assign(scenario, 0.04);
        scenario.drillString.endTime = 6e-3;  // of longer ones the waves are those of fewer pieces
        const Blow blow = solveBlow(scenario, {}, Detail::histories, {}, Stresses::wanted);
        QVERIFY(blow.impact.waves);
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

    void wavesOfManyPiecesAreThoseOfFewer() {
        Scenario scenario = test::losslessString();
        findParameter("string.1.end_diameter")->assign(scenario, 0.03);
        findParameter("hammer.1.end_diameter")->assign(scenario, 0.04);
        checkThinnedWaves(scenario);
    }

    void wavesOfLengthsThatShareNoCellAreThoseOfRoundedOnes() {
        Scenario scenario = test::losslessString();
        findParameter("string.3.length")->assign(scenario, 3.6571);
        findParameter("hammer.1.length")->assign(scenario, 0.29993);
        checkThinnedWaves(scenario);
    }

  private:
    /// Numbers are those without waves; the waves reach the end of the blow, give nearly the same peak force,
    /// and an alert says how far they are off.
    static void checkThinnedWaves(const Scenario& scenario) {
        const Blow alone = solveBlow(scenario, {}, Detail::summary);
        const Blow blow = solveBlow(scenario, {}, Detail::histories);
        QVERIFY(blow.impact.isSolved());
        QVERIFY(blow.impact.waves);
        QVERIFY(blow.impact.wavesDifference);
        QVERIFY2(*blow.impact.wavesDifference < 0.01, QByteArray::number(*blow.impact.wavesDifference));
        QVERIFY(std::abs(blow.impact.cor - alone.impact.cor) <= alone.impact.corError);
        const auto alert = std::ranges::find(blow.alerts, AlertCode::wavesThinned, &Alert::code);
        QVERIFY(alert != blow.alerts.end());
        QCOMPARE(alert->argument("difference").value, *blow.impact.wavesDifference);
        QVERIFY(std::ranges::find(alone.alerts, AlertCode::wavesThinned, &Alert::code) == alone.alerts.end());
        double peak = 0;
        for (int i = 0; i <= 4000; ++i)
            peak = std::max(peak, blow.impact.force(blow.impact.waves->end() * i / 4000));
        QVERIFY2(std::abs(peak / blow.impact.peakForce - 1) < 0.02,
                 QByteArray::number(peak / blow.impact.peakForce));
    }
};

QTEST_GUILESS_MAIN(TestChainSolution)
#include "tst_chain_solution.moc"
