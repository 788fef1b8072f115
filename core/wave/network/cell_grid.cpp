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

/// The cell of which round trips are whole numbers: by least squares.
class CellFit {
  public:
    void add(double roundTrip, double count) {
        m_product += roundTrip * count;
        m_square += count * count;
    }
    /// To a cell so many times smaller.
    void refine(double times) {
        m_product *= times;
        m_square *= times * times;
    }
    double cell() const { return m_product / m_square; }

  private:
    double m_product = 0, m_square = 0;
};

double largestRounding(const std::vector<UniformSection>& sections, const CellGrid& grid) {
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

bool shareGrid(const std::vector<UniformSection>& sections, double leastCell, CellGrid& grid) {
    double longest = 0;
    for (const UniformSection& section : sections) longest = std::max(longest, 2 * section.transitTime);
    // Euclid's rounding grows from division to division: what fits all round trips so far has none of it
    CellFit fit;
    fit.add(longest, 1);
    for (const UniformSection& section : sections) {
        const double roundTrip = 2 * section.transitTime;
        const double cell = sharedMeasure(fit.cell(), roundTrip, longest * sameLength);
        if (cell < leastCell) return false;
        fit.refine(std::round(fit.cell() / cell));
        fit.add(roundTrip, std::round(roundTrip / cell));
    }
    CellFit ofSections;
    for (const UniformSection& section : sections)
        ofSections.add(2 * section.transitTime, std::round(2 * section.transitTime / fit.cell()));
    roundGrid(sections, ofSections.cell(), grid);
    return grid.rounding <= longest * sameLength;
}

void roundGrid(const std::vector<UniformSection>& sections, double cell, CellGrid& grid) {
    grid.cell = cell;
    grid.roundTrips.clear();
    for (const UniformSection& section : sections)
        grid.roundTrips.push_back(std::max(1L, std::lround(2 * section.transitTime / cell)));
    grid.rounding = largestRounding(sections, grid);
}

}  // namespace drillwave
