// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensionless blow for tests and benchmarks: a pulse shape and the four groups.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/units.h"
#include "core/wave/problem.h"

namespace drillwave::test {

/// Random numbers in the same sequence on every machine.
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : m_random(seed) {}
    unsigned below(unsigned n) { return static_cast<unsigned>(m_random() % n); }
    bool oneIn(unsigned n) { return below(n) == 0; }
    double fraction() { return static_cast<double>(m_random() >> 11) * 0x1p-53; }
    double logarithmic(double low, double high) { return low * std::pow(high / low, fraction()); }

  private:
    std::mt19937_64 m_random;
};

/// Parameters of a hammer force like a measured one: unevenly spaced points of a steep rise and a slow fall,
/// with ripples and noise. The same seed gives the same table.
struct TableShape {
    int points = 50;
    unsigned seed = 1;
};

inline std::vector<TablePoint> tablePoints(const TableShape& table) {
    Chance chance(table.seed);
    const double ripples = 2 + 10 * chance.fraction(), rise = 0.05 + 0.3 * chance.fraction();
    std::vector<TablePoint> points;
    double time = 0;
    for (int i = 0; i < table.points; ++i, time += 0.2 + chance.fraction()) points.push_back({time, 0});
    for (TablePoint& point : points) {
        const double x = point.time / points.back().time;
        const double bell = x < rise ? x / rise : (1 - x) / (1 - rise);
        const double ripple = 1 + 0.2 * std::sin(2 * 3.141592653589793 * ripples * x);
        point.force = std::max(0.0, bell * ripple + 0.02 * (chance.fraction() - 0.5));
    }
    if (points.size() == 2) points.front().force = 1;
    return points;
}

inline PulseForce pulseForceOf(const TableShape& table) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = PulseShape::table;
    scenario.pulse.tablePoints = TablePoints(tablePoints(table));
    return drillwave::pulseForceOf(scenario);
}

/// Dimensionless blow: a pulse shape and the four groups β, γ, τ and δ.
struct Scene {
    PulseShape shape = PulseShape::rectangular;
    Groups groups;
    double impedanceRatio = 2;  ///< impedance of a piston over that of the rod
    TableShape table = {};      ///< parameters of the table, for that pulse shape
};

inline PulseForce pulseForceOf(const Scene& scene) {
    return scene.shape == PulseShape::table ? pulseForceOf(scene.table)
                                            : drillwave::pulseForceOf(scene.shape, scene.impedanceRatio);
}

inline Problem problemOf(const Scene& scene) {
    return problemOf(pulseForceOf(scene), scene.groups);
}

/// Returns a description from which a failing blow can be reproduced.
inline std::string describe(const Scene& scene) {
    std::string words = std::string(name(scene.shape)) + " beta " + formatNumber(scene.groups.beta) +
                        " gamma " + formatNumber(scene.groups.gamma) + " tau " +
                        formatNumber(scene.groups.tau) + " delta " + formatNumber(scene.groups.delta);
    if (scene.shape == PulseShape::piston) words += " impedance ratio " + formatNumber(scene.impedanceRatio);
    if (scene.shape == PulseShape::table)
        words +=
            " points " + std::to_string(scene.table.points) + " seed " + std::to_string(scene.table.seed);
    return words;
}

}  // namespace drillwave::test
