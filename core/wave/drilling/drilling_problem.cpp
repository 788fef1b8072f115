// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/drilling/drilling_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/wave/network/cell_cuts.h"

namespace drillwave {

namespace {

/// A time may differ from whole cells by that share of it and be whole.
constexpr double wholeShare = 1e-9;

/// A round trip may differ from whole cells by that share of it and be whole: shareGrid() takes 1e-9 of the
/// longest one.
constexpr double wholeTrip = 1e-6;

/// A frequency that is rounded by less is kept; ten times more is worth cells a third as large.
constexpr double keptRounding = 1e-7;

/// A blow may take so many cells to have its interval in whole ones.
constexpr double affordableCells = 2000;

/// Cells are made smaller than the one wanted by up to this so that all round trips are whole ones, and by up
/// to that so that none is less than one.
constexpr double mostRefinement = 8, mostRefinementOfShort = 16;

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

/// All cells in as many parts as there are places of jumps inside them, and one more; where round trips are
/// not whole cells a jump has no place that stays, and they have one part.
void cutAtJumps(DrillingGrid& grid, const Problem& blow) {
    grid.cuts.begin(grid.cell, {}, {});
    if (!blow.isForced() || !grid.hasWholeTrips()) return;
    for (const double place : placesOf(jumpsOf(blow.force()), grid.cell)) grid.cuts.endPartAt(place);
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

/// The largest cell of which an interval is a whole number, and jumps are so as nearly as they can.
double cellOfInterval(double interval, double wanted, const std::vector<double>& jumps) {
    const double fewest = std::ceil(interval / wanted - wholeShare);
    if (jumps.empty()) return interval / fewest;
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (double count = fewest; count <= fewest + std::max(1.0, std::ceil(fewest / 4)); ++count) {
        const double cell = interval / count;
        double off = 0;
        for (const double time : jumps) off += std::abs(time / cell - std::round(time / cell));
        if (off < least - wholeShare) least = off, best = cell;
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
    CellGrid shared;
    double shortest = std::numeric_limits<double>::infinity();
    for (const UniformSection& section : blow.sections)
        shortest = std::min(shortest, 2 * section.transitTime);
    if (blow.sections.size() == 1) {
        const long fewest =
            std::max(fewestCells, static_cast<long>(std::ceil(shortest / wanted - wholeShare)));
        grid.cell = bestCell({shortest, fewest, most(shortest, fewest, 2)}, problem.interval, jumps);
    } else if (shareGrid(blow.sections, wanted / mostRefinement, shared)) {
        const double trip = shared.cell;
        const long fewest = std::max(1L, static_cast<long>(std::ceil(trip / wanted - wholeShare)));
        grid.cell = bestCell({trip, fewest, std::min(most(trip, fewest, 2), std::max(fewest, 8L))},
                             problem.interval, jumps);
    } else {
        const double largest = std::min(wanted, std::max(shortest, wanted / mostRefinementOfShort));
        grid.cell = cellOfInterval(problem.interval, largest, jumps);
    }
    grid.cellsOfInterval = std::max(1L, std::lround(problem.interval / grid.cell));
    grid.setSections(blow.sections);
    cutAtJumps(grid, blow);
    return grid;
}

/// Cells that could be twice as large are looked for; the round trips of a string may share none.
bool isFineEnough(const DrillingGrid& grid, int cellsPerDuration) {
    return grid.cell * cellsPerDuration <= 1 + wholeShare;
}

DrillingGrid halved(DrillingGrid grid, const DrillingProblem& problem) {
    grid.cell /= 2;
    for (double& trip : grid.roundTrips) trip *= 2;
    grid.cellsOfInterval *= 2;
    cutAtJumps(grid, problem.blow);
    return grid;
}

}  // namespace

bool losesWaves(const DrillingProblem& problem) {
    return std::ranges::any_of(problem.waveLosses, [](double loss) { return loss > 0; }) ||
           losesWaves(problem.blow);
}

void DrillingGrid::setSections(const std::vector<UniformSection>& sections) {
    roundTrips.clear();
    for (const UniformSection& section : sections) {
        const double trip = 2 * section.transitTime / cell, whole = std::round(trip);
        roundTrips.push_back(std::abs(trip - whole) <= wholeTrip * std::max(trip, 1.0) ? whole : trip);
    }
}

bool DrillingGrid::hasWholeTrips() const {
    return std::ranges::all_of(roundTrips, [](double trip) { return trip == std::round(trip); });
}

std::optional<std::size_t> DrillingGrid::shortSection() const {
    const auto found = std::ranges::find_if(roundTrips, [](double trip) { return trip < 1; });
    if (found == roundTrips.end()) return std::nullopt;
    return static_cast<std::size_t>(found - roundTrips.begin());
}

DrillingGrid drillingGridOf(const DrillingProblem& problem, int cellsPerDuration) {
    DrillingGrid grid = gridOf(problem, 2.0 / cellsPerDuration);
    if (!isFineEnough(grid, cellsPerDuration)) grid = halved(grid, problem);
    grid.releasesAtOnce = grid.hasWholeTrips();
    return grid;
}

DrillingGrid comparedDrillingGridOf(const DrillingProblem& problem, int cellsPerDuration) {
    const DrillingGrid grid = gridOf(problem, 2.0 / cellsPerDuration);
    return isFineEnough(grid, cellsPerDuration) ? halved(grid, problem) : grid;
}

}  // namespace drillwave
