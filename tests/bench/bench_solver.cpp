// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds per COR evaluation, scene by scene: a table, or with --json an array. Not run by ctest.
#include <cstdio>
#include <cstring>
#include <string>

#include "core/numeric/run_time.h"
#include "core/text/units.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/problem.h"

using namespace drillwave;

namespace {

struct Scene {
    const char* name;
    PulseShape shape;
    Groups groups;
};

const Scene scenes[] = {
    {"elastic", PulseShape::rectangular, {0.5, 1, 10, 0}},
    {"bilinear", PulseShape::rectangular, {0.5, 0.1, 10, 0}},
    {"reference", PulseShape::rigidBody, {0.5, 1, 10, 0}},
    {"gap", PulseShape::rectangular, {0.5, 0.1, 10, 0.521}},
    {"soft", PulseShape::rectangular, {0.01, 0.1, 10, 0}},
    {"stiff", PulseShape::rectangular, {1e6, 0.01, 10, 0}},
    {"near_elastic", PulseShape::rectangular, {0.5, 0.99999999, 10, 0}},
    {"half_sine", PulseShape::halfSine, {0.5, 0.1, 10, 0}},
    {"triangular", PulseShape::triangular, {0.5, 0.1, 10, 0}},
    {"piston", PulseShape::piston, {0.5, 0.1, 10, 0}},
    {"softest", PulseShape::rectangular, {1e-7, 0.1, 0.5, 0}},
    {"stiffest", PulseShape::rectangular, {1e9, 1e-6, 10, 0.3}},
};

struct Measured {
    RunTime time;
    long pieces = 0;
};

Measured measure(const Scene& scene) {
    const Problem problem = problemOf(pulseForceOf(scene.shape, 2), scene.groups);
    ExactSolver solver;
    Measured measured;
    const auto work = [&] { measured.pieces = solver.solve(problem, Detail::cor).pieces; };
    work();  // warm
    measured.time = measureRunTime(work, 0, {}, [] {});
    return measured;
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "usage: bench_solver [--json]\n");
        return 2;
    }
    if (!json)
        std::printf("%-13s %-12s %9s %11s %5s %6s %12s %12s %7s\n", "scene", "shape", "beta", "gamma", "tau",
                    "delta", "median", "minimum", "pieces");
    const char* separator = "[";
    for (const Scene& scene : scenes) {
        const auto [timing, pieces] = measure(scene);
        const std::string shape(name(scene.shape));
        const auto number = [](double value) { return formatNumber(value); };
        const Groups& g = scene.groups;
        if (json)
            std::printf(
                "%s\n {\"scene\": \"%s\", \"shape\": \"%s\", \"beta\": %s, \"gamma\": %s, \"tau\": %s, "
                "\"delta\": %s, \"median_s\": %s, \"min_s\": %s, \"pieces\": %ld}",
                separator, scene.name, shape.c_str(), number(g.beta).c_str(), number(g.gamma).c_str(),
                number(g.tau).c_str(), number(g.delta).c_str(), number(timing.median).c_str(),
                number(timing.least).c_str(), pieces);
        else
            std::printf("%-13s %-12s %9s %11s %5s %6s %9.3f us %9.3f us %7ld\n", scene.name, shape.c_str(),
                        number(g.beta).c_str(), number(g.gamma).c_str(), number(g.tau).c_str(),
                        number(g.delta).c_str(), 1e6 * timing.median, 1e6 * timing.least, pieces);
        separator = ",";
    }
    if (json) std::printf("\n]\n");
}
