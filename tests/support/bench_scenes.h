// SPDX-License-Identifier: GPL-3.0-or-later
// Test blows for the speed of the exact solver: timed by bench_solver, counted by tst_amount_of_work.
#pragma once

#include <array>
#include <vector>

#include "tests/support/scene.h"

namespace drillwave::test {

struct NamedScene {
    std::string name;
    Scene scene;
};

/// Returns blows with names. Each pulse shape also occurs with β 0.5 and 5 and γ 0.1 and 1 (τ 10, δ 0), named
/// "half_sine 5 0.1".
inline std::vector<NamedScene> benchScenes() {
    using enum PulseShape;
    std::vector<NamedScene> scenes{
        {"elastic", {rectangular, {0.5, 1, 10, 0}}},
        {"bilinear", {rectangular, {0.5, 0.1, 10, 0}}},
        {"reference", {rigidBody, {0.5, 1, 10, 0}}},
        {"gap", {rectangular, {0.5, 0.1, 10, 0.521}}},
        {"soft", {rectangular, {0.01, 0.1, 10, 0}}},
        {"stiff", {rectangular, {1e6, 0.01, 10, 0}}},
        {"near_elastic", {rectangular, {0.5, 0.99999999, 10, 0}}},
        {"half_sine", {halfSine, {0.5, 0.1, 10, 0}}},
        {"triangular", {triangular, {0.5, 0.1, 10, 0}}},
        {"piston", {piston, {0.5, 0.1, 10, 0}}},
        {"softest", {rectangular, {1e-7, 0.1, 0.5, 0}}},
        {"stiffest", {rectangular, {1e9, 1e-6, 10, 0.3}}},
    };
    for (const PulseShape shape :
         {rectangular, triangular, halfSine, trapezoid, exponential, piston, table, rigidBody})
        for (const double beta : {0.5, 5.0})
            for (const double gamma : {0.1, 1.0})
                scenes.push_back(
                    {std::string(name(shape)) + ' ' + formatNumber(beta) + ' ' + formatNumber(gamma),
                     {shape, {beta, gamma, 10, 0}}});
    return scenes;
}

/// Random blows of one pulse shape, in the same sequence on every machine.
class RandomBench {
  public:
    enum class Domain {
        engineering,  ///< β 0.01 … 100, γ 0.05 … 1, τ 0.3 … 20, δ 0 … 2, q 0.05 … 20, tables of 50 points
        extreme,  ///< β 1e-7 … 1e9, γ 1e-6 … 1, τ 0.05 … 1000, δ to 1e6, tables of up to 1000 points
    };

    RandomBench(Domain domain, PulseShape shape)
        : m_domain(domain), m_shape(shape), m_chance(100 + unsigned(shape)) {}

    Scene next() {
        const bool wide = m_domain == Domain::extreme;
        Scene scene;
        scene.shape = m_shape;
        scene.impedanceRatio = m_chance.logarithmic(0.05, 20);
        scene.table.seed = m_chance.below(1'000'000);
        if (wide) scene.table.points = int(m_chance.logarithmic(2, 1000));
        Groups& g = scene.groups;
        g.beta = wide ? m_chance.logarithmic(1e-7, 1e9) : m_chance.logarithmic(0.01, 100);
        g.gamma = wide ? m_chance.logarithmic(1e-6, 1) : m_chance.logarithmic(0.05, 1);
        g.tau = wide ? m_chance.logarithmic(0.05, 1000) : m_chance.logarithmic(0.3, 20);
        g.delta = 2 * m_chance.fraction();
        if (wide && m_chance.oneIn(2)) g.delta = m_chance.logarithmic(1, 1e6);
        if (wide && m_chance.oneIn(4)) g.gamma = 1;
        if (m_shape == PulseShape::rigidBody) g.delta = 0;
        return scene;
    }

  private:
    Domain m_domain;
    PulseShape m_shape;
    Chance m_chance;
};

}  // namespace drillwave::test
