// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/drilling/drilling_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

/// A time may differ from whole cells by that share of it and be whole.
constexpr double wholeShare = 1e-9;

/// A frequency that is rounded by less is kept; ten times more is worth cells a third as large.
constexpr double keptRounding = 1e-7;

/// A blow may take so many cells to have its interval in whole ones.
constexpr double affordableCells = 2000;

/// Round trips that share a cell smaller than the one wanted by more than this are rounded instead.
constexpr double mostRefinement = 8;

/// Fronts at more places in a cell stay where they are.
constexpr std::size_t mostFronts = 8;

/// Fewer cells in a round trip of a rod place no contact.
constexpr long fewestCells = 4;

/// Less than that of the largest force is no jump of it.
constexpr double leastJump = 1e-9;

/// Times at which a force jumps [t0].
std::vector<double> jumpsOf(const PulseForce& force) {
    std::vector<double> times;
    double before = 0;
    for (const PulseSegment& segment : force.segments) {
        if (std::abs(segment.forceAt(0) - before) > leastJump * force.peak && segment.start > 0)
            times.push_back(segment.start);
        before = segment.forceAt(segment.length);
    }
    if (before > leastJump * force.peak) times.push_back(force.end);
    return times;
}

/// How far a time is from whole cells, as a share of it.
double misfit(double time, double cell) {
    const double cells = time / cell;
    return std::abs(cells - std::round(cells)) / std::max(cells, 1.0);
}

/// Where in a cell the jumps lie that are not at its ends, from 0 to 1.
std::vector<double> placesOf(const std::vector<double>& jumps, double cell) {
    std::vector<double> places;
    for (const double time : jumps) {
        const double place = time / cell - std::floor(time / cell);
        const double tolerance = wholeShare * std::max(time / cell, 1.0);
        if (place <= tolerance || place >= 1 - tolerance) continue;
        const bool known =
            std::ranges::any_of(places, [&](double other) { return std::abs(other - place) <= tolerance; });
        if (!known) places.push_back(place);
    }
    if (places.size() > mostFronts) places.resize(mostFronts);
    return places;
}

/// All cells in as many parts as there are places of jumps inside them, and one more.
void cutAtJumps(DrillingGrid& grid, const std::vector<double>& jumps) {
    grid.cuts.begin(grid.cells.cell, {}, {});
    for (const double place : placesOf(jumps, grid.cells.cell)) grid.cuts.endPartAt(place);
}

/// The sizes of cells among which one is chosen, the largest first: all divide `trip`.
struct Choices {
    double trip;
    long fewest, most;
};

/// The largest cell that fits the interval; of those that do not, the one that fits it best. One in which no
/// jump lies is worth twice as many cells.
double bestCell(const Choices& choices, double interval, const std::vector<double>& jumps) {
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (long count = choices.fewest; count <= choices.most; ++count) {
        const double cell = choices.trip / static_cast<double>(count);
        const double rounding = std::max(misfit(interval, cell), keptRounding);
        const double parts = static_cast<double>(1 + placesOf(jumps, cell).size());
        const double cost = static_cast<double>(count) * parts * std::sqrt(rounding / keptRounding);
        if (cost < least) least = cost, best = cell;
    }
    return best;
}

/// With cells of that size at most, as few as do.
DrillingGrid gridOf(const DrillingProblem& problem, double wanted) {
    const Problem& blow = problem.blow;
    const std::vector<double> jumps = blow.isForced() ? jumpsOf(blow.force()) : std::vector<double>();
    // a short interval is rounded the more by its cells, and has few of them
    const auto most = [&](double trip, long fewest, long usual) {
        const double affordable = affordableCells * trip / problem.interval;
        return std::max(usual * fewest, static_cast<long>(std::min(affordable, 1e6)));
    };
    DrillingGrid grid;
    if (blow.sections.size() == 1) {
        const double trip = 2 * blow.sections.front().transitTime;
        const long fewest = std::max(fewestCells, static_cast<long>(std::ceil(trip / wanted - wholeShare)));
        roundGrid(blow.sections, bestCell({trip, fewest, most(trip, fewest, 2)}, problem.interval, jumps),
                  grid.cells);
    } else if (shareGrid(blow.sections, wanted / mostRefinement, grid.cells)) {
        const double shared = grid.cells.cell;
        const long fewest = std::max(1L, static_cast<long>(std::ceil(shared / wanted - wholeShare)));
        roundGrid(blow.sections,
                  bestCell({shared, fewest, std::min(most(shared, fewest, 2), std::max(fewest, 8L))},
                           problem.interval, jumps),
                  grid.cells);
    } else {
        roundGrid(blow.sections, problem.interval / std::ceil(problem.interval / wanted), grid.cells);
    }
    grid.cellsOfInterval = std::max(1L, std::lround(problem.interval / grid.cells.cell));
    cutAtJumps(grid, jumps);
    return grid;
}

/// Cells that could be twice as large are looked for; the round trips of a string may share none.
bool isFineEnough(const DrillingGrid& grid, int cellsPerDuration) {
    return grid.cells.cell * cellsPerDuration <= 1 + wholeShare;
}

DrillingGrid halved(DrillingGrid grid, const DrillingProblem& problem) {
    grid.cells.halve();
    grid.cellsOfInterval *= 2;
    cutAtJumps(grid, problem.blow.isForced() ? jumpsOf(problem.blow.force()) : std::vector<double>());
    return grid;
}

}  // namespace

DrillingGrid drillingGridOf(const DrillingProblem& problem, int cellsPerDuration) {
    const DrillingGrid grid = gridOf(problem, 2.0 / cellsPerDuration);
    return isFineEnough(grid, cellsPerDuration) ? grid : halved(grid, problem);
}

DrillingGrid comparedDrillingGridOf(const DrillingProblem& problem, int cellsPerDuration) {
    const DrillingGrid grid = gridOf(problem, 2.0 / cellsPerDuration);
    return isFineEnough(grid, cellsPerDuration) ? halved(grid, problem) : grid;
}

}  // namespace drillwave
