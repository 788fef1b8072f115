// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of a study of designs, and how its errors fall with the number of samples, beside plain Monte Carlo:
// bench_design --help. ctest only tries that it runs.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <random>
#include <string_view>

#include "core/study/design/design_check.h"
#include "core/study/design/design_study.h"
#include "core/study/design/scenario_designs.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/bench/bench_table.h"

using namespace drillwave;
using namespace drillwave::bench;

namespace {

constexpr const char* usage =
    R"(usage: bench_design [--speed | --errors] [--seeds N] [--reference N] [--csv | --json]
  --speed        processor time of studies on one thread (default)
  --errors       the T38 piston at 240 us and constant energy, stiffness, gamma and gap uncertain: errors of
                 what is told of it by the number of samples, against a study of many, over several seeds
  --seeds N      so many (20)
  --reference N  samples of the study that the others are held against, a power of two (1048576)
)";

using Kind = Column::Kind;

struct Options {
    bool errors = false;
    int seeds = 20;
    std::uint64_t reference = std::uint64_t{1} << 20;
    Format format = Format::text;
};

/// A built-in scenario whose bit and rock are not known.
DesignStudy studyOf(const char* example) {
    DesignStudy study;
    study.base = parseScenario(findExample(example)->text, example).scenario;
    for (const char* text :
         {"bit_rock.stiffness=50MN/m:250MN/m:log", "bit_rock.gamma=0.05:0.3", "bit_rock.gap=0mm:1mm"})
        study.uncertain.push_back(parseUncertain(text).input);
    study.aims = customaryAims(study.base);
    return study;
}

void choose(DesignStudy& study, const char* key, std::vector<double> values) {
    SweepAxis axis;
    axis.parameter = findParameter(key);
    axis.unit = &axis.parameter->displayUnit();
    axis.count = values.size();
    axis.list = std::move(values);
    study.choices.push_back(std::move(axis));
}

std::vector<double> evenly(double first, double last, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(first + (last - first) * i / (count - 1));
    return values;
}

void benchSpeed(const Options& options) {
    Table table(options.format, {{"study", 26, Kind::word},
                                 {"designs", 7},
                                 {"samples", 7},
                                 {"solves", 8},
                                 {"total_s", 10, Kind::time},
                                 {"solve_s", 10, Kind::time}});
    const auto add = [&](const char* name, const DesignStudy& study) {
        std::uint64_t solves = 0;
        const std::clock_t start = std::clock();  // of all threads
        runDesign(study, {.jobs = 1, .progress = [&](std::uint64_t more) { solves += more; }});
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        table.add({name, double(study.designCount()), double(study.samples), double(solves), seconds,
                   seconds / double(solves)});
    };
    DesignStudy rod = studyOf("t38_medium_rock");
    choose(rod, "pulse.duration", evenly(100e-6, 400e-6, 96));
    rod.keepsEnergy = true;
    add("rod, 96 durations", rod);
    DesignStudy string = studyOf("t38_string");
    choose(string, "hammer.velocity", evenly(6, 12, 4));
    string.samples = 1024;
    add("string, 4 velocities", string);
}

/// A quantity in the findings of a study; NaN if it is missing.
struct Told {
    const char* name;
    Estimate (*of)(const DesignFindings&, const DesignStudy&);
};

Estimate statisticOf(const DesignFindings& found, const DesignStudy& study, const char* output,
                     Statistic statistic) {
    const StatisticPlace place = study.placeOf(*findOutput(output), statistic);
    const SampledValue& value = found.designs[0].statistics[place.output][place.statistic];
    return {value.value, value.error()};
}

constexpr Statistic mean{Statistic::Kind::mean}, q05{Statistic::Kind::quantile, 5},
    q95{Statistic::Kind::quantile, 95};

const Told told[] = {
    {"efficiency mean",
     [](const DesignFindings& f, const DesignStudy& s) { return statisticOf(f, s, "efficiency", mean); }},
    {"efficiency q05",
     [](const DesignFindings& f, const DesignStudy& s) { return statisticOf(f, s, "efficiency", q05); }},
    {"thrust q95 [N]",
     [](const DesignFindings& f, const DesignStudy& s) { return statisticOf(f, s, "thrust", q95); }},
    {"total index of gamma",
     [](const DesignFindings& f, const DesignStudy&) { return f.sensitivity.outputs[0].indices[1].total; }},
    {"first index of stiffness",
     [](const DesignFindings& f, const DesignStudy&) { return f.sensitivity.outputs[0].indices[0].first; }},
    {"worst efficiency",
     [](const DesignFindings& f, const DesignStudy&) {
         return Estimate{f.worst[0]->value, std::numeric_limits<double>::quiet_NaN()};
     }},
    {"the same, only sampled",
     [](const DesignFindings& f, const DesignStudy&) {
         return Estimate{f.worst[0]->sampled, std::numeric_limits<double>::quiet_NaN()};
     }},
};

/// Errors over the seeds.
struct Errors {
    std::vector<double> off = {}, stated = {}, monteCarlo = {};

    static double rms(const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value * value;
        return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                              : std::sqrt(sum / double(values.size()));
    }
    /// Errors beyond what is stated are not counted where that is nothing.
    double held() const {
        if (stated.empty() || std::isnan(stated[0])) return std::numeric_limits<double>::quiet_NaN();
        int count = 0;
        for (std::size_t i = 0; i < off.size(); ++i) count += std::abs(off[i]) <= stated[i];
        return count / double(off.size());
    }
};

/// Returns the study's statistics by independent random points instead of its own: in the order of `told`,
/// without indices and worst cases.
std::vector<double> monteCarlo(const DesignStudy& study, unsigned seed) {
    const ScenarioDesigns problem(study);
    const std::vector<Distribution> distributions = problem.distributions(0);
    const std::unique_ptr<DesignSolver> solver = problem.solver();
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<double> values(distributions.size()), outputs(problem.outputCount()), efficiency, thrust;
    for (std::uint64_t n = 0; n < study.samples; ++n) {
        std::ranges::transform(distributions, values.begin(),
                               [&](const Distribution& of) { return of.quantile(share(random)); });
        if (!solver->solve(0, values, outputs, {}).isEmpty()) continue;
        efficiency.push_back(outputs[0]);
        thrust.push_back(outputs[1]);
    }
    const SortedSamples efficiencies(efficiency), thrusts(thrust);
    return {efficiencies.of(mean).value, efficiencies.of(q05).value, thrusts.of(q95).value};
}

void benchErrors(const Options& options) {
    Table table(options.format, {{"of", 25, Kind::word},
                                 {"samples", 7},
                                 {"rms_error", 9, Kind::ratio},
                                 {"stated", 8, Kind::ratio},
                                 {"within", 6, Kind::share},
                                 {"monte_carlo", 11, Kind::ratio}});
    DesignStudy study = studyOf("t38_medium_rock");
    choose(study, "pulse.duration", {240e-6});
    study.keepsEnergy = true;
    study.samples = options.reference;
    study.seed = 1'000'000;
    const DesignFindings reference = runDesign(study, {.jobs = 1});
    for (study.samples = 256; study.samples <= options.reference / 16; study.samples *= 4) {
        std::vector<Errors> errors(std::size(told));
        for (int seed = 1; seed <= options.seeds; ++seed) {
            study.seed = static_cast<std::uint64_t>(seed);
            const DesignFindings found = runDesign(study, {.jobs = 1});
            const std::vector<double> random = monteCarlo(study, static_cast<unsigned>(seed));
            for (std::size_t i = 0; i < std::size(told); ++i) {
                const double exact = told[i].of(reference, study).value;
                const Estimate value = told[i].of(found, study);
                errors[i].off.push_back(value.value - exact);
                errors[i].stated.push_back(value.error);
                if (i < random.size()) errors[i].monteCarlo.push_back(random[i] - exact);
            }
        }
        for (std::size_t i = 0; i < std::size(told); ++i)
            table.add({told[i].name, double(study.samples), Errors::rms(errors[i].off),
                       Errors::rms(errors[i].stated), errors[i].held(), Errors::rms(errors[i].monteCarlo)});
    }
}

template <class Number>
bool readNumber(std::string_view text, Number least, Number& number) {
    const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
    return error == std::errc{} && end == text.end() && number >= least;
}

bool read(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--speed") {
            options.errors = false;
        } else if (word == "--errors") {
            options.errors = true;
        } else if (word == "--csv") {
            options.format = Format::csv;
        } else if (word == "--json") {
            options.format = Format::json;
        } else if (word == "--seeds" && i + 1 < argc) {
            if (!readNumber(argv[++i], 1, options.seeds)) return false;
        } else if (word == "--reference" && i + 1 < argc) {
            if (!readNumber(argv[++i], leastDesignSamples, options.reference)) return false;
        } else {
            return false;
        }
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (!read(argc, argv, options)) {
        std::fputs(usage, stderr);
        return 2;
    }
    if (options.errors)
        benchErrors(options);
    else
        benchSpeed(options);
}
