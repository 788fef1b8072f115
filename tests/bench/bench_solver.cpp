// SPDX-License-Identifier: GPL-3.0-or-later
// Processor time of solves, scene by scene and over random scenes by shape: bench_solver --help. ctest only
// tries that it runs.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <limits>
#include <string_view>

#include "core/numeric/run_time.h"
#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/exact/exponential_basis.h"
#include "core/wave/exact/exponential_domain.h"
#include "core/wave/lattice/lattice_solver.h"
#include "tests/bench/bench_table.h"
#include "tests/support/bench_scenes.h"

using namespace drillwave;
using namespace drillwave::bench;
using namespace drillwave::test;

namespace {

constexpr const char* usage = R"(usage: bench_solver [GROUP…] [--count N] [--csv | --json]
  --scenes    named scenes and every shape of the blow: time for e alone, how many times as much the summary
              and the histories take, and the paper's lattice of 10 000 segments with a ring buffer (default)
  --domain    1000 random scenes of each shape: beta 0.01-100, gamma 0.05-1, tau 0.3-20, delta 0-2
  --extreme   100 of each shape: beta 1e-7-1e9, gamma from 1e-6, tau 0.05-1000, delta to 1e6
  --corner    those of --domain whose loading has one corner, over the same without
  --count N   so many random scenes
)";

constexpr double none = std::numeric_limits<double>::quiet_NaN();
using Kind = Column::Kind;

struct Options {
    bool scenes = false, domain = false, extreme = false, corner = false;
    int count = 0;  ///< 0: the usual ones
    Format format = Format::text;
};

/// Median and least time of a solve; what is slow is solved once.
template <class Work>
RunTime timeOf(const Work& work) {
    const double start = threadSeconds();
    work();
    const double first = threadSeconds() - start;
    if (first > 0.2) return {.median = first, .least = first, .runs = 1};
    return measureRunTime(work, 0, {}, [] {});
}

double latticeSeconds(const Problem& problem) {
    LatticeSolver lattice;
    bool solved = false;
    const RunTime time = timeOf([&] {
        solved = lattice.solve(problem, Detail::cor, {.estimate = ErrorEstimate::none}).outcome ==
                 Outcome::rebounded;
    });
    return solved ? time.median : none;
}

void benchScene(Table& table, const NamedScene& named) {
    const Problem problem = problemOf(named.scene);
    ExactSolver solver;
    Impact impact;
    const auto timeFor = [&](Detail detail) {
        return timeOf([&] { impact = solver.solve(problem, detail); });
    };
    const double histories = timeFor(Detail::histories).median, summary = timeFor(Detail::summary).median;
    const RunTime cor = timeFor(Detail::cor);
    const Groups& g = named.scene.groups;
    table.add({named.name, std::string(name(named.scene.shape)), g.beta, g.gamma, g.tau, g.delta, cor.median,
               cor.least, double(impact.pieces), double(impact.searches), double(impact.samples),
               summary / cor.median, histories / cor.median, latticeSeconds(problem) / cor.median});
}

void benchScenesOf(const Options& options) {
    Table table(options.format, {{"scene", 19, Kind::word},
                                 {"shape", 11, Kind::word},
                                 {"beta", 5},
                                 {"gamma", 10},
                                 {"tau", 3},
                                 {"delta", 5},
                                 {"median_s", 9, Kind::time},
                                 {"min_s", 8, Kind::time},
                                 {"pieces", 6},
                                 {"searches", 8},
                                 {"samples", 7},
                                 {"summary", 7, Kind::ratio},
                                 {"histories", 9, Kind::ratio},
                                 {"lattice", 8, Kind::ratio}});
    for (const NamedScene& scene : benchScenes()) benchScene(table, scene);
}

/// Times of random blows of one shape, or of all.
struct Sample {
    std::vector<double> seconds;
    int closed = 0, notSolved = 0;

    void add(const Sample& other) {
        seconds.insert(seconds.end(), other.seconds.begin(), other.seconds.end());
        closed += other.closed;
        notSolved += other.notSolved;
    }
};

/// The least of three runs, what is quick repeated until the clock can tell.
double secondsOf(ExactSolver& solver, const Problem& problem, Sample& sample) {
    constexpr double resolved = 30e-6, slow = 1e-3;
    double start = threadSeconds();
    const Impact impact = solver.solve(problem);
    double least = threadSeconds() - start;
    sample.notSolved += impact.outcome != Outcome::rebounded;
    const int repeats = int(std::clamp(std::ceil(resolved / least), 1.0, 100.0));
    for (int run = 0; run < 3 && least < slow; ++run) {
        start = threadSeconds();
        for (int i = 0; i < repeats; ++i) solver.solve(problem);
        least = std::min(least, (threadSeconds() - start) / repeats);
    }
    return least;
}

Sample sampleOf(RandomBench::Domain domain, PulseShape shape, int count) {
    RandomBench scenes(domain, shape);
    ExactSolver solver;
    ContactMarch<ExponentialBasis<2>> march;
    Sample sample;
    for (int i = 0; i < count; ++i) {
        const Problem problem = problemOf(scenes.next());
        sample.seconds.push_back(secondsOf(solver, problem, sample));
        Impact closed;
        if (suitsExponentials(problem)) march.solve(problem, Detail::cor, closed, {.pieces = 2000});
        sample.closed += closed.outcome == Outcome::rebounded;
    }
    return sample;
}

void addRow(Table& table, std::string words, Sample sample) {
    std::ranges::sort(sample.seconds);
    const auto count = sample.seconds.size();
    double sum = 0;
    for (const double seconds : sample.seconds) sum += seconds;
    table.add({std::move(words), double(count), sample.seconds[count / 2],
               sample.seconds[(count * 99 + 99) / 100 - 1], sample.seconds.back(), sum / double(count),
               sample.closed / double(count), double(sample.notSolved)});
}

void benchDomain(const Options& options, RandomBench::Domain domain, int usualCount) {
    Table table(options.format, {{"shape", 12, Kind::word},
                                 {"blows", 6},
                                 {"median_s", 10, Kind::time},
                                 {"p99_s", 9, Kind::time},
                                 {"max_s", 9, Kind::time},
                                 {"mean_s", 9, Kind::time},
                                 {"closed", 7, Kind::share},
                                 {"not_solved", 10}});
    const int count = options.count > 0 ? options.count : usualCount;
    Sample all;
    for (std::size_t shape = 0; shape < pulseShapeNames().size(); ++shape) {
        const Sample sample = sampleOf(domain, PulseShape(shape), count);
        addRow(table, std::string(name(PulseShape(shape))), sample);
        all.add(sample);
    }
    addRow(table, "all", all);
}

/// One corner at some share of the largest force, whose line is softer or stiffer.
void addCorner(Problem& problem, double peakForce, Chance& chance) {
    const double steepest = std::min(6.0, 1 / problem.law.gamma);
    const double force = peakForce * chance.logarithmic(0.1, 0.98);
    problem.law.corners = {{force, chance.logarithmic(0.05, steepest)}};
}

void benchCorners(const Options& options) {
    Table table(options.format, {{"shape", 12, Kind::word},
                                 {"blows", 6},
                                 {"median_s", 10, Kind::time},
                                 {"median_ratio", 12, Kind::ratio},
                                 {"p90_ratio", 9, Kind::ratio}});
    const int count = options.count > 0 ? options.count : 1000;
    const auto addRow = [&](std::string words, std::vector<double> seconds, std::vector<double> ratios) {
        std::ranges::sort(seconds);
        std::ranges::sort(ratios);
        table.add({std::move(words), double(seconds.size()), seconds[seconds.size() / 2],
                   ratios[ratios.size() / 2], ratios[ratios.size() * 9 / 10]});
    };
    ExactSolver solver;
    std::vector<double> allSeconds, allRatios;
    for (std::size_t shape = 0; shape < pulseShapeNames().size(); ++shape) {
        RandomBench scenes(RandomBench::Domain::engineering, PulseShape(shape));
        Chance chance(shape);
        std::vector<double> seconds, ratios;
        Sample sample;
        for (int i = 0; i < count; ++i) {
            Problem problem = problemOf(scenes.next());
            const double without = secondsOf(solver, problem, sample);
            addCorner(problem, solver.solve(problem).peakForce, chance);
            seconds.push_back(secondsOf(solver, problem, sample));
            ratios.push_back(seconds.back() / without);
        }
        addRow(std::string(name(PulseShape(shape))), seconds, ratios);
        allSeconds.insert(allSeconds.end(), seconds.begin(), seconds.end());
        allRatios.insert(allRatios.end(), ratios.begin(), ratios.end());
    }
    addRow("all", allSeconds, allRatios);
}

bool read(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--scenes") {
            options.scenes = true;
        } else if (word == "--domain") {
            options.domain = true;
        } else if (word == "--extreme") {
            options.extreme = true;
        } else if (word == "--corner") {
            options.corner = true;
        } else if (word == "--csv") {
            options.format = Format::csv;
        } else if (word == "--json") {
            options.format = Format::json;
        } else if (word == "--count" && i + 1 < argc) {
            const std::string_view count = argv[++i];
            const auto [end, error] = std::from_chars(count.begin(), count.end(), options.count);
            if (error != std::errc{} || end != count.end() || options.count < 1) return false;
        } else {
            return false;
        }
    }
    const int groups = options.domain + options.extreme + options.corner;
    if (groups == 0) options.scenes = true;
    return options.scenes + groups == 1 || options.format == Format::text;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (!read(argc, argv, options)) {
        std::fputs(usage, stderr);
        std::fputs("CSV and JSON take one group at a time.\n", stderr);
        return 2;
    }
    if (options.scenes) benchScenesOf(options);
    if (options.domain) benchDomain(options, RandomBench::Domain::engineering, 1000);
    if (options.extreme) benchDomain(options, RandomBench::Domain::extreme, 100);
    if (options.corner) benchCorners(options);
}
