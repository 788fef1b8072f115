// SPDX-License-Identifier: GPL-3.0-or-later
// Blows for tests of the solvers: solved blows, reference cases and random ones.
#pragma once

#include <QTest>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/text/csv.h"
#include "core/wave/exact/exact_solver.h"
#include "tests/support/scene.h"

namespace drillwave::test {

inline Impact solve(const Scene& scene, Detail detail = Detail::cor) {
    ExactSolver solver;
    return solver.solve(problemOf(scene), detail);
}

inline double cor(PulseShape shape, double beta, double gamma, double tau, double delta) {
    return solve({shape, {beta, gamma, tau, delta}}).cor;
}

/// Adds data rows with a column "scene": one blow for each kind of wave pattern in a rod.
inline void addRodScenes() {
    QTest::addColumn<Scene>("scene");
    QTest::newRow("paper Fig. 4 (a)") << Scene{PulseShape::rectangular, {0.5, 1, 10, 0}};
    QTest::newRow("paper Fig. 4 (b)") << Scene{PulseShape::rectangular, {0.5, 0.1, 10, 0}};
    QTest::newRow("triangular") << Scene{PulseShape::triangular, {0.9, 0.3, 2.3, 0.4}};
    QTest::newRow("half sine") << Scene{PulseShape::halfSine, {2, 0.05, 3.3, 0.9}};
    QTest::newRow("hammer longer than a round trip") << Scene{PulseShape::trapezoid, {0.7, 0.3, 0.21, 0.4}};
    QTest::newRow("piston") << Scene{PulseShape::piston, {5, 0.2, 1.7, 0}};
    QTest::newRow("reference case") << Scene{PulseShape::rigidBody, {0.5, 0.1, 2, 0}};
    QTest::newRow("gap of ten periods") << Scene{PulseShape::rectangular, {0.7, 0.3, 4, 10.3}};
}

/// One row of tests/cases/reference.csv, a reference solution with 33 digits.
struct ReferenceCase {
    Scene scene;
    double cor, peakForce, residualPenetration, separationTime, rockWork;
};

inline std::vector<ReferenceCase> referenceCases() {
    std::ifstream file(DRILLWAVE_SOURCE_DIR "/tests/cases/reference.csv");
    CsvReader reader(file);
    CsvRecord record;
    reader.next(record);  // header
    std::vector<ReferenceCase> cases;
    while (reader.next(record)) {
        const auto number = [&](std::size_t column) { return parseNumber(record.cells.at(column)).value(); };
        const auto shape = findPulseShape(record.cells.at(0));
        if (!shape) throw std::runtime_error("unknown shape in reference.csv: " + record.cells.at(0));
        cases.push_back({{*shape, {number(1), number(2), number(3), number(4)}},
                         number(5),
                         number(6),
                         number(7),
                         number(8),
                         number(9)});
    }
    return cases;
}

/// Ranges of the groups from which random blows are drawn, on logarithmic scales.
struct Domain {
    double leastBeta, mostBeta, leastGamma, leastTau, mostTau, mostDelta;
};
inline constexpr Domain engineeringDomain{1e-3, 1e3, 0.01, 0.05, 1000, 100};
inline constexpr Domain extremeDomain{1e-7, 1e9, 1e-6, 0.05, 1000, 1000};

/// Returns true if a blow can be solved quickly. Long blows on short rods need up to a million wave pieces,
/// too slow for tests of thousands.
inline bool isQuick(const Problem& problem) {
    if (problem.transitTime() < 1.5 && problem.force().end > 1) return false;
    return problem.law.beta > 1e-5 || problem.law.gamma > 0.3;
}

/// Random blows of every pulse shape, in the same sequence on every machine. γ = 1 and nearly 1, whole-number
/// gaps and commensurate transit times occur often.
class RandomScenes {
  public:
    RandomScenes(const Domain& domain, unsigned seed) : m_domain(domain), m_chance(seed) {}

    Scene next() {
        static constexpr PulseShape shapes[] = {
            PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine, PulseShape::trapezoid,
            PulseShape::exponential, PulseShape::piston,     PulseShape::rigidBody};
        Scene scene;
        scene.shape = shapes[m_chance.below(7)];
        scene.impedanceRatio = m_chance.logarithmic(0.3, 5);
        Groups& g = scene.groups;
        g.beta = m_chance.logarithmic(m_domain.leastBeta, m_domain.mostBeta);
        g.gamma = m_chance.logarithmic(m_domain.leastGamma, 1);
        if (m_chance.below(3) == 0) g.gamma = 1;
        if (m_chance.below(10) == 0) g.gamma = 1 - m_chance.logarithmic(1e-12, 0.1);
        g.tau = m_chance.logarithmic(m_domain.leastTau, m_domain.mostTau);
        if (m_chance.below(10) == 0) g.tau = 0.5 * (1 + m_chance.below(8));
        switch (m_chance.below(4)) {
            case 0:
                g.delta = 0;
                break;
            case 1:
                g.delta = m_chance.below(4);
                break;
            case 2:
                g.delta = 3 * m_chance.fraction();
                break;
            default:
                g.delta = m_chance.logarithmic(1e-6, m_domain.mostDelta);
        }
        if (scene.shape == PulseShape::rigidBody) g.delta = 0;
        return scene;
    }

    /// Returns the next blow that can be solved quickly, see isQuick().
    Scene nextQuick() {
        for (;;)
            if (const Scene scene = next(); isQuick(problemOf(scene))) return scene;
    }

    /// Solves n quick blows by solver(scene) and calls check(scene, impact) for the solved ones, until a
    /// check fails. Also fails if the solved share is below `leastShare`, because checks that are skipped
    /// prove nothing.
    template <typename Solver, typename Check>
    void forEachSolved(int n, const Solver& solver, const Check& check, double leastShare = 0.8) {
        int solved = 0;
        std::string refused;
        for (int i = 0; i < n; ++i) {
            const Scene scene = nextQuick();
            const Impact impact = solver(scene);
            if (impact.outcome != Outcome::rebounded) {
                refused = describe(scene) + ": " + impact.reason.text();
                continue;
            }
            ++solved;
            check(scene, impact);
            if (QTest::currentTestFailed()) return;
        }
        QVERIFY2(solved >= leastShare * n,
                 (std::to_string(solved) + " of " + std::to_string(n) + " solved; not " + refused).c_str());
    }

    /// Does the same with the exact solver, which must solve all n blows.
    template <typename Check>
    void forEachSolved(int n, Detail detail, const Check& check) {
        forEachSolved(
            n, [detail](const Scene& scene) { return solve(scene, detail); }, check, 1);
    }

  private:
    Domain m_domain;
    Chance m_chance;
};

}  // namespace drillwave::test
