// SPDX-License-Identifier: GPL-3.0-or-later
// Random rods and drill strings under many blows.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "core/wave/drilling/drilling_problem.h"

namespace drillwave::test {

/// Returns a random rod, or a string of up to four sections with a hammer. Transit times are multiples of
/// t0/100.
inline DrillingProblem randomDrilling(std::mt19937& random, bool isString) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    const auto alike = [&](double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    };
    DrillingProblem problem;
    Problem& blow = problem.blow;
    const auto time = [&](double low, double high) { return std::round(100 * alike(low, high)) / 100; };
    if (isString) {
        blow.sections.clear();
        ElasticHammer hammer;
        hammer.sections = 1;
        hammer.face.restrike = between(0, 1) < 0.5;
        if (between(0, 1) < 0.3) hammer.face.stiffness = alike(1, 30);
        blow.drive = hammer;
        blow.sections.push_back({.impedance = alike(0.5, 2), .transitTime = 0.5});
        const int count = 1 + static_cast<int>(between(0, 4));
        for (int i = 0; i < count; ++i)
            blow.sections.push_back({.impedance = i == 0 ? 1 : alike(0.5, 2),
                                     .transitTime = time(0.2, 3),
                                     .massAfter = between(0, 1) < 0.3 ? alike(0.02, 0.5) : 0});
        blow.law = {.beta = alike(0.05, 20), .gamma = alike(0.02, 1)};
    } else {
        blow = problemOf(pulseForceOf(between(0, 1) < 0.5 ? PulseShape::rectangular : PulseShape::halfSine),
                         {.beta = alike(0.05, 20), .gamma = alike(0.02, 1), .tau = time(0.3, 20)});
    }
    if (between(0, 1) < 0.5) blow.gap = between(0, 2);
    const double roundTrips = alike(1.5, 60);
    problem.interval = std::max(2.0, 2 * blow.transitTime() * roundTrips);
    const double impulse = isString ? blow.sections[0].mass() * blow.hammer().velocity : 1;
    problem.feedForce = between(1.01, 5) * impulse / problem.interval * (isString ? 1.6 : 1);
    problem.waveLosses.assign(blow.sections.size(), 0);
    const double loss = between(0, 0.5);
    for (std::size_t j = blow.hammerSections(); j < blow.sections.size(); ++j) problem.waveLosses[j] = loss;
    if (between(0, 1) < 0.75) {
        problem.machine = MachineBody{.mass = alike(1, 100) * blow.mass(),
                                      .damping = between(0, 2),
                                      .stiffness = between(0, 1) < 0.5 ? between(0, 0.3) : 0};
        if (problem.machine->damping + problem.machine->stiffness == 0) problem.machine.reset();
    }
    problem.isFresh = between(0, 1) < 0.8;
    return problem;
}

}  // namespace drillwave::test
