// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

/// A round trip may differ from whole cells by this share of the longest one.
constexpr double sameLength = 1e-9;

/// The greatest length of which both are multiples but for `tolerance`: Euclid's algorithm.
double sharedMeasure(double a, double b, double tolerance) {
    while (b > tolerance) {
        double rest = std::fmod(a, b);
        if (b - rest < tolerance) rest = 0;
        a = b;
        b = rest;
    }
    return a;
}

double largestRounding(const std::vector<NetworkSection>& sections, const CellGrid& grid) {
    double largest = 0;
    for (std::size_t j = 0; j < sections.size(); ++j)
        largest = std::max(largest, std::abs(2 * sections[j].transitTime -
                                             static_cast<double>(grid.roundTrips[j]) * grid.cell));
    return largest;
}

}  // namespace

void CellGrid::halve() {
    cell /= 2;
    for (long& count : roundTrips) count *= 2;
}

bool shareGrid(const std::vector<NetworkSection>& sections, double leastCell, CellGrid& grid) {
    double longest = 0;
    for (const NetworkSection& section : sections) longest = std::max(longest, 2 * section.transitTime);
    double cell = longest;
    for (const NetworkSection& section : sections) {
        cell = sharedMeasure(cell, 2 * section.transitTime, longest * sameLength);
        if (cell < leastCell) return false;
    }
    // one measure was carried from section to section: now the one that fits all of them best
    double product = 0, square = 0;
    for (const NetworkSection& section : sections) {
        const double count = std::round(2 * section.transitTime / cell);
        product += 2 * section.transitTime * count;
        square += count * count;
    }
    roundGrid(sections, product / square, grid);
    return grid.rounding <= longest * sameLength;
}

void roundGrid(const std::vector<NetworkSection>& sections, double cell, CellGrid& grid) {
    grid.cell = cell;
    grid.roundTrips.clear();
    for (const NetworkSection& section : sections)
        grid.roundTrips.push_back(std::max(1L, std::lround(2 * section.transitTime / cell)));
    grid.rounding = largestRounding(sections, grid);
}

}  // namespace drillwave
