// SPDX-License-Identifier: GPL-3.0-or-later
// The two representations of the waves against each other, long double and the lattice, in random scenes by
// shape: compare_bases --help. Not run by ctest but for a trial; tst_bases holds what it shows.
#include <array>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/basis_comparison.h"
#include "tests/support/basis_scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr const char* usage = R"(usage: compare_bases [OPTION VALUE…]
  --scenes N    how many, 20000 by default
  --first N     number of the first, 0 by default; with --scenes 1 a single one, in all digits
  --seed N      of another sequence
  --shape NAME  only that
  --truth N     every Nth in long double as well, 20 by default, and all that differ; 0: only these
  --lattice N   every Nth of those in closed form by the lattice, 200 by default; 0: none
  --failures N  how many to print, 10 by default
  --summary N   1: ask for the summary, and compare that
  --ungated N   1: try the closed basis in every scene, whether it suits or not
Exit code 1 when two results contradict each other's bounds where no growth of errors excuses it.
)";

struct Options {
    unsigned scenes = 20'000, first = 0, seed = 1, truth = 20, lattice = 200, failures = 10, summary = 0,
             ungated = 0;
    std::optional<PulseShape> shape = {};
};

/// Worst and counts of one shape, or of all.
struct Tally {
    unsigned scenes = 0, suited = 0, closed = 0, series = 0, wrong = 0, wrongOfGrowth = 0, otherContacts = 0,
             otherEvents = 0, lattices = 0;
    double excess = 0, difference = 0, closedFromTruth = 0, seriesFromTruth = 0, latticeExcess = 0;
    double peak = 0, rockWork = 0, hammerWork = 0, energy = 0;
    std::vector<double> closedSeconds, seriesSeconds;

    void add(const BasisFinding& found) {
        const auto keep = [](double& worst, double value) {
            if (value > worst) worst = value;
        };
        ++scenes;
        suited += found.isSuited;
        series += found.series.isSolved();
        if (found.isWrong()) ++(found.growth() > coveredGrowth ? wrongOfGrowth : wrong);
        if (found.growth() <= coveredGrowth) keep(seriesFromTruth, found.series.differenceTo(found.extended));
        if (!found.closed.isSolved()) return;
        ++closed;
        closedSeconds.push_back(found.closed.seconds);
        seriesSeconds.push_back(found.series.seconds);
        keep(excess, found.closed.excessOver(found.series));
        if (found.growth() <= coveredGrowth) {
            keep(difference, found.closed.differenceTo(found.series));
            keep(closedFromTruth, found.closed.differenceTo(found.extended));
        }
        if (found.lattice.isSolved()) {
            ++lattices;
            keep(latticeExcess, found.closed.excessOver(found.lattice));
        }
        if (!found.series.isSolved()) return;
        const Impact &a = found.closed.impact, &b = found.series.impact;
        otherContacts += a.contacts != b.contacts;
        otherEvents += a.events.size() != b.events.size();
        if (found.growth() > coveredGrowth) return;
        const auto away = [&](double x, double y) { return std::abs(x - y) / std::max(1.0, std::abs(y)); };
        keep(peak, away(a.peakForce, b.peakForce));
        keep(rockWork, away(a.rockWork, b.rockWork));
        keep(hammerWork, away(a.hammerWork, b.hammerWork));
        keep(energy, away(a.hammerWork, a.rockWork + a.finalEnergy));
    }
};

double medianMicroseconds(std::vector<double> seconds) {
    if (seconds.empty()) return 0;
    std::ranges::sort(seconds);
    return 1e6 * seconds[seconds.size() / 2];
}

void print(const char* name, const Tally& t, bool summary) {
    std::printf("%-12s %6u %6u %6u %6u %5u %6u %8u %9.2g %9.1e %9.1e %9.1e %8.2f %8.2f", name, t.scenes,
                t.suited, t.closed, t.series, t.wrong, t.wrongOfGrowth, t.otherContacts, t.excess,
                t.difference, t.closedFromTruth, t.seriesFromTruth, medianMicroseconds(t.closedSeconds),
                medianMicroseconds(t.seriesSeconds));
    std::printf(" %5u %8.2g", t.lattices, t.latticeExcess);
    if (summary)
        std::printf(" %7u %8.1e %8.1e %8.1e %8.1e", t.otherEvents, t.peak, t.rockWork, t.hammerWork,
                    t.energy);
    std::printf("\n");
}

void printHeader(bool summary) {
    std::printf("%-12s %6s %6s %6s %6s %5s %6s %8s %9s %9s %9s %9s %8s %8s %5s %8s", "shape", "scenes",
                "suited", "closed", "series", "wrong", "growth", "contacts", "of bounds", "closed-s.",
                "closed-ld", "series-ld", "us", "us s.", "latt.", "of est.");
    if (summary) std::printf(" %7s %8s %8s %8s %8s", "events", "peak", "rock w.", "hammer", "energy");
    std::printf("\n");
}

void print(unsigned number, const BasisFinding& found) {
    std::printf("\n%u: %s\n", number, describe(found.scene).c_str());
    const auto line = [](const char* name, const BasisResult& result) {
        const Impact& i = result.impact;
        if (result.isSolved())
            std::printf("  %-8s e %.17g +- %.2g, %d contacts, %ld pieces, growth %.3g\n", name, i.cor,
                        i.corError, i.contacts, i.pieces, i.growth);
        else if (!i.reason.isEmpty())
            std::printf("  %-8s not solved: %s\n", name, i.reason.text().c_str());
    };
    line("closed", found.closed);
    line("series", found.series);
    line("long", found.extended);
    line("lattice", found.lattice);
}

std::optional<Options> optionsOf(int argc, char** argv) {
    Options options;
    struct Known {
        const char* name;
        unsigned* value;
    };
    const Known known[] = {{"--scenes", &options.scenes},   {"--first", &options.first},
                           {"--seed", &options.seed},       {"--truth", &options.truth},
                           {"--lattice", &options.lattice}, {"--failures", &options.failures},
                           {"--summary", &options.summary}, {"--ungated", &options.ungated}};
    for (int i = 1; i < argc; i += 2) {
        if (i + 1 == argc) return {};
        const std::string_view word = argv[i + 1];
        if (std::strcmp(argv[i], "--shape") == 0) {
            options.shape = findPulseShape(word);
            if (!options.shape) return {};
            continue;
        }
        const auto* option = std::ranges::find_if(
            known, [&](const Known& each) { return std::strcmp(each.name, argv[i]) == 0; });
        if (option == std::end(known)) return {};
        const auto [end, error] = std::from_chars(word.begin(), word.end(), *option->value);
        if (error != std::errc{} || end != word.end()) return {};
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<Options> options = optionsOf(argc, argv);
    if (!options) {
        std::fputs(usage, stderr);
        return 2;
    }
    BasisScenes scenes(options->seed, options->shape);
    BasisComparison comparison;
    comparison.triesUnsuited = options->ungated;
    if (options->summary) comparison.detail = Detail::ledger;
    std::array<Tally, 8> tallies;
    Tally all;
    unsigned printed = 0;
    const auto isDue = [](unsigned number, unsigned every) { return every > 0 && number % every == 0; };
    for (unsigned i = 0; i < options->scenes; ++i) {
        const unsigned number = options->first + i;
        // the shapes take turns: each of them is due as often
        const BasisFinding found = comparison.compare(scenes.scene(number), isDue(number / 8, options->truth),
                                                      isDue(number / 8, options->lattice));
        tallies.at(std::size_t(found.scene.shape)).add(found);
        all.add(found);
        if (options->scenes == 1 || (found.isWrong() && printed++ < options->failures)) print(number, found);
    }
    std::printf("\n");
    printHeader(options->summary);
    for (std::size_t shape = 0; shape < tallies.size(); ++shape)
        if (tallies.at(shape).scenes > 0)
            print(name(PulseShape(shape)).data(), tallies.at(shape), options->summary);
    print("all", all, options->summary);
    return all.wrong > 0 ? 1 : 0;
}
