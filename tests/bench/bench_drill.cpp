// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of many blows, beside a plain lattice of straight cells, and how their errors fall with the cells:
// bench_drill --help. ctest only tries that it runs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string_view>
#include <vector>

#include "core/study/drilling/drilling_statistics.h"
#include "core/study/scan/drilling_scan.h"
#include "core/wave/drilling/drilling_march.h"
#include "core/wave/drilling/drilling_problem.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/bench/bench_table.h"

using namespace drillwave;
using namespace drillwave::bench;

namespace {

constexpr const char* usage =
    R"(usage: bench_drill [--speed | --scan | --errors] [--blows N] [--csv | --json]
  --speed    processor time of a blow and of a cell at a node, beside a plain lattice of straight cells (default)
  --scan     processor time of a scan over 100 thrusts on one thread, with 20 cells per t0, each from rest and
             from bouncing, where blows are needed only until both are the same motion
  --errors   gap and penetration by the number of cells: of a motion that repeats against 640 per t0, also where
             the end of the force lies inside a cell, and means of an irregular one against 320, beside what
             they differ by chance
  --blows N  so many of each (400; of a scan 1000)
)";

using Kind = Column::Kind;

double seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

/// β 0.5, γ 0.1, τ 3.5, n_b 12, η 0.1; with the damper ζ 0.15, μ 6.8.
DrillingProblem rod(double phi, bool damped) {
    DrillingProblem problem;
    problem.blow = problemOf(pulseForceOf(PulseShape::rectangular), {.beta = 0.5, .gamma = 0.1, .tau = 3.5});
    problem.interval = 2 * 3.5 * 12;
    problem.feedForce = phi / problem.interval;
    problem.waveLosses = {0.1};
    if (damped) problem.machine = MachineBody{.mass = 6.8 * 3.5, .damping = 0.15, .stiffness = 0};
    return problem;
}

/// The example with a coupling of that length [mm]: 190 makes all sections whole hundredths of a metre.
DrillingProblem string(double coupling) {
    Scenario scenario = parseScenario(findExample("t38_string")->text, "t38_string").scenario;
    findParameter("string.coupling.length")->assign(scenario, coupling / 1000);
    scenario.drill.machineMass = 200;
    scenario.drill.damperDamping = 6300;
    scenario.drill.waveLoss = 0.1;
    if (!scenario.drill.blowFrequency) scenario.drill.blowFrequency = 60;
    if (!scenario.drill.thrust) scenario.drill.thrust = 8000;
    return drillingProblemOf(scenario, problemOf(scenario));
}

/// A rod of straight cells by their means, without damper and loss: the least that a blow can cost.
double plainBlow(long blows) {
    constexpr int cells = 40, trip = 280, interval = 3360;
    constexpr double width = 1.0 / cells, beta = 0.5, gamma = 0.1;
    std::vector<double> line(trip, 0.0);
    double place = 0, largest = 0, sum = 0;
    std::size_t at = 0;
    const double start = seconds();
    for (long blow = 0; blow < blows; ++blow) {
        for (int cell = 0; cell < interval; ++cell) {
            const double down = (cell < cells ? 1.0 : 0.0) + 0.4 / 84 - line[at];
            // the trapezoidal rule for U' = 2g − F(U)
            const auto force = [&](double u) {
                const double most = largest / beta;
                return u >= most ? beta * u : std::max(0.0, largest - beta / gamma * (most - u));
            };
            const double before = force(place), guess = place + width * (2 * down - before);
            const double after = force(guess);
            place += width * (2 * down - (before + after) / 2);
            const double now = force(place);
            largest = std::max(largest, now);
            line[at] = now - down;
            at = at + 1 == trip ? 0 : at + 1;
            sum += now;
        }
        place -= (1 - gamma) * largest / beta;
        largest = 0;
    }
    const double spent = seconds() - start;
    if (sum < 0) std::puts("no such sum");
    return spent / double(blows);
}

void benchSpeed(Format format, long blows) {
    Table table(format, {{"scene", 26, Kind::word},
                         {"cells", 8},
                         {"nodes", 6},
                         {"blow_s", 11, Kind::time},
                         {"cell_and_node_s", 15, Kind::time},
                         {"over_plain", 10, Kind::ratio}});
    const double plain = plainBlow(blows);
    const auto add = [&](const char* name, const DrillingProblem& problem) {
        const DrillingGrid grid = drillingGridOf(problem, 40);
        DrillingMarch march(problem, grid);
        for (int i = 0; i < 5; ++i) (void)march.takeBlow({});
        const double start = seconds();
        for (long i = 0; i < blows; ++i) (void)march.takeBlow({});
        const double each = (seconds() - start) / double(blows);
        const double cells = double(grid.cellsOfInterval) * double(grid.cuts.count());
        table.add({name, cells, double(problem.blow.sections.size() + 1), each, each / grid.work(problem),
                   each / plain});
    };
    table.add({"rod, plain lattice", 3360.0, 2.0, plain, plain / 6720, 1.0});
    add("rod, constant force", rod(2, false));
    add("rod, damper", rod(2, true));
    add("T38 string, damper", string(190));
    add("coupling of 187 mm", string(187));
}

/// rod() in SI, at 5 km/s; its damper has 212 kg and 6680 N s/m.
constexpr const char* rodInUnits = R"(drillwave: 1
rod: {length: 3.5 m, diameter: 38 mm, youngs_modulus: 196.25 GPa, density: 7850 kg/m^3}
pulse: {shape: rectangular, duration: 200 us, impulse: 40 N s}
bit_rock: {stiffness: 111.3 MN/m, gamma: 0.1}
drill: {blow_frequency: 59.523809523809526 Hz, thrust: 5 kN, wave_loss: 10 %}
)";

/// Over φ of 1.05 to 2.6.
void benchScan(Format format, long blows) {
    constexpr const char* thrusts = "drill.thrust=2.5kN:6.2kN:100";
    Table table(format, {{"scene", 26, Kind::word},
                         {"values", 7},
                         {"blows", 7},
                         {"from_bouncing", 14},
                         {"scan_s", 11, Kind::time}});
    DrillingSettings settings;
    settings.blows = blows;
    settings.settle = blows / 4;
    settings.cells = scanCells;
    const auto add = [&](const char* name, const Scenario& scenario) {
        const double start = seconds();
        const DrillingScan scan = scanDrilling(scenario, parseAxis(thrusts).axis, settings, {});
        table.add(
            {name, double(scan.axis.count), double(blows), double(scan.bouncingBlows), seconds() - start});
    };
    Scenario scenario = parseScenario(rodInUnits, "rod").scenario;
    add("rod, constant force", scenario);
    scenario.drill.machineMass = 212;
    scenario.drill.damperDamping = 6680;
    add("rod, damper", scenario);
}

struct Found {
    double gap = 0, penetration = 0;            ///< [d0], of the last blow or means
    double gapError = 0, penetrationError = 0;  ///< of means, by batches of blows
    double residual = 0, time = 0;
};

/// Returns the last blow of a motion that repeats, else the means of all but the first quarter.
Found findWith(const DrillingProblem& problem, const DrillingGrid& grid, long blows, bool repeats) {
    DrillingMarch march(problem, grid);
    std::vector<DrillingBlow> taken;
    const double start = seconds();
    for (long i = 0; i < blows; ++i) {
        (void)march.takeBlow({});
        taken.push_back(march.blow());
    }
    Found found;
    found.time = (seconds() - start) / double(blows);
    found.residual = march.ledger().residual() / march.ledger().hammer;
    if (repeats) {
        found.gap = taken.back().gap / 2;
        found.penetration = taken.back().penetration / 2;
        return found;
    }
    const DrillingStatistics statistics =
        statisticsOf(taken, std::size_t(blows / 4), problem.blow.velocity());
    const BlowSpread& gap = statistics.spreads[quantityPlace(&DrillingBlow::gap)];
    const BlowSpread& penetration = statistics.spreads[quantityPlace(&DrillingBlow::penetration)];
    found.gap = gap.mean / 2;
    found.penetration = penetration.mean / 2;
    found.gapError = gap.meanError.value_or(0) / 2;
    found.penetrationError = penetration.meanError.value_or(0) / 2;
    return found;
}

/// Returns a grid for a rod with so many cells per round trip and some more: the force ends inside a cell.
DrillingGrid withEndInside(const DrillingProblem& problem, int cells) {
    constexpr long tripsOfInterval = 12, more = 3;
    const double roundTrip = 2 * problem.blow.transitTime();
    const long trip = std::lround(cells * roundTrip) + more;
    DrillingGrid grid = drillingGridOf(problem, cells);
    grid.cell = roundTrip / static_cast<double>(trip);
    grid.roundTrips = {static_cast<double>(trip)};
    grid.cuts.begin(grid.cell, {}, {});
    grid.cellsOfInterval = tripsOfInterval * trip;
    return grid;
}

void benchErrors(Format format, long blows) {
    Table table(format, {{"motion", 10, Kind::word},
                         {"cells", 6},
                         {"gap_off", 12, Kind::ratio},
                         {"gap_chance", 12, Kind::ratio},
                         {"penetration_off", 16, Kind::ratio},
                         {"penetration_chance", 19, Kind::ratio},
                         {"energy_residual", 16, Kind::ratio},
                         {"blow_s", 11, Kind::time}});
    struct Motion {
        const char* name;
        bool repeats, endsInside;
    };
    for (const Motion& motion :
         {Motion{"repeats", true, false}, Motion{"inside", true, true}, Motion{"irregular", false, false}}) {
        const bool repeats = motion.repeats;
        const DrillingProblem problem = rod(1.4, repeats);  // a constant force leaves it irregular
        const Found exact = findWith(problem, drillingGridOf(problem, repeats ? 640 : 320), blows, repeats);
        for (const int cells : {10, 20, 40, 80, 160}) {
            const Found found = findWith(
                problem, motion.endsInside ? withEndInside(problem, cells) : drillingGridOf(problem, cells),
                blows, repeats);
            const auto both = [](double a, double b) { return std::sqrt(a * a + b * b); };
            table.add({motion.name, double(cells), std::abs(found.gap - exact.gap),
                       both(found.gapError, exact.gapError), std::abs(found.penetration - exact.penetration),
                       both(found.penetrationError, exact.penetrationError), found.residual, found.time});
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    Format format = Format::text;
    bool errors = false, scan = false;
    std::optional<long> given;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--errors")
            errors = true;
        else if (word == "--scan")
            scan = true;
        else if (word == "--csv")
            format = Format::csv;
        else if (word == "--json")
            format = Format::json;
        else if (word == "--blows" && i + 1 < argc)
            given = std::max(1L, std::strtol(argv[++i], nullptr, 10));
        else if (word != "--speed")
            return std::fputs(usage, word == "--help" ? stdout : stderr), word == "--help" ? 0 : 2;
    }
    if (scan)
        benchScan(format, given.value_or(1000));
    else if (errors)
        benchErrors(format, given.value_or(400));
    else
        benchSpeed(format, given.value_or(400));
    return 0;
}
