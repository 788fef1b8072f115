// SPDX-License-Identifier: GPL-3.0-or-later
// Test blows on rock whose loading curve has corners: reference cases and random ones.
#pragma once

#include <sstream>

#include "tests/support/scenes.h"

namespace drillwave::test {

inline Problem withCorners(Problem problem, std::vector<LawCorner> corners) {
    problem.law.corners = std::move(corners);
    return problem;
}

/// One row of tests/cases/corner_cases.csv, a reference solution with 33 digits. Penetrations are in units of
/// d0, efficiency and loading work in units of W.
struct CornerCase {
    Scene scene;
    std::vector<LawCorner> corners;
    double cor, peakForce, largestPenetration, residualPenetration, efficiency, loadingWork, separationTime;
    int contacts, passes;
    Problem problem() const { return withCorners(problemOf(scene), corners); }
};

inline std::vector<CornerCase> cornerCases() {
    std::ifstream file(DRILLWAVE_SOURCE_DIR "/tests/cases/corner_cases.csv");
    CsvReader reader(file);
    CsvRecord record;
    reader.next(record);  // header
    std::vector<CornerCase> cases;
    while (reader.next(record)) {
        const auto number = [&](std::size_t column) { return parseNumber(record.cells.at(column)).value(); };
        const auto shape = findPulseShape(record.cells.at(0));
        if (!shape) throw std::runtime_error("unknown shape in corner_cases.csv: " + record.cells.at(0));
        CornerCase next{{*shape, {number(1), number(2), number(3), number(4)}},
                        {},
                        number(6),
                        number(7),
                        number(8),
                        number(9),
                        number(10),
                        number(11),
                        number(12),
                        int(number(13)),
                        int(number(14))};
        std::istringstream corners(record.cells.at(5));
        for (std::string pair; std::getline(corners, pair, ';');) {
            const std::size_t colon = pair.find(':');
            next.corners.push_back(
                {parseNumber(pair.substr(0, colon)).value(), parseNumber(pair.substr(colon + 1)).value()});
        }
        cases.push_back(next);
    }
    return cases;
}

/// Returns one to eight random corners at forces up to about `largest`, with slopes between 1/50 and 1/γ.
/// Some have the slope of the line before, and some that of unloading, 1/γ.
inline std::vector<LawCorner> randomCorners(double largest, double gamma, Chance& chance) {
    std::vector<LawCorner> corners;
    const double steepest = 1 / gamma;
    double force = 0;
    for (int left = 1 + chance.below(8); left > 0; --left) {
        force += largest * chance.logarithmic(1e-3, 0.6);
        double slope = std::min(chance.logarithmic(0.02, 5), steepest);
        if (chance.below(10) == 0) slope = corners.empty() ? 1 : corners.back().slope;
        if (chance.below(10) == 0) slope = steepest;
        corners.push_back({force, slope});
    }
    return corners;
}

/// Returns random corners at forces that occur in a blow on this rod.
inline std::vector<LawCorner> randomCorners(const Problem& problem, Chance& chance) {
    const double largest = 2.2 * std::max(problem.force().peak, 1 / (2 * problem.transitTime()));
    return randomCorners(largest, problem.law.gamma, chance);
}

}  // namespace drillwave::test
