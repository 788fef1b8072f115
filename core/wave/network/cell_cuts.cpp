// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/cell_cuts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace drillwave {

namespace {

/// Where the parts behind a front end: the rest of a cell is one part.
constexpr double longestPart = 0.8;

/// So many times its own length behind a front a rate has died away: parts may grow faster.
constexpr double diedAway = 25, growthBehind = 4;

/// Rates so fast that what they lose in a cell is below 1e-9 of it need no parts.
constexpr double wallRate = 1e9;

/// Cells in more parts than that are cut no more.
constexpr std::size_t mostParts = 400;

/// Cuts nearer to each other than that are one.
constexpr double nearestCut = 1e-9;

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

void CellCuts::begin(double cell, const std::vector<double>& rates, const Grading& grading) {
    m_cell = cell;
    m_grading = grading;
    m_rates.clear();
    for (const double rate : rates)
        if (rate * cell > grading.first && rate * cell <= wallRate) m_rates.push_back(rate * cell);
    m_jumps = 0;
    m_places.assign(1, 0);
    addGraded(0);
    measure();
}

/// How long a part may be at some distance behind a front.
double CellCuts::stepBehind(double distance) const {
    double step = (growthBehind - 1) * distance + (distance > 0 ? 0 : 1);
    for (const double rate : m_rates)
        if (rate * distance < diedAway)
            step = std::min(step, std::max(m_grading.first / rate, (m_grading.growth - 1) * distance));
    return step;
}

bool CellCuts::add(double place) {
    const auto next = std::lower_bound(m_places.begin(), m_places.end(), place);
    const double after = next != m_places.end() ? *next : 1;
    if (after - place <= nearestCut || place - *(next - 1) <= nearestCut) return false;
    m_places.insert(next, place);
    return true;
}

void CellCuts::addGraded(double place) {
    for (double behind = stepBehind(0); behind < longestPart; behind += stepBehind(behind)) {
        const double at = place + behind;
        add(at < 1 ? at : at - 1);
    }
}

void CellCuts::measure() {
    m_widths.clear();
    for (std::size_t i = 0; i < m_places.size(); ++i)
        m_widths.push_back(m_cell * ((i + 1 < m_places.size() ? m_places[i + 1] : 1) - m_places[i]));
}

bool CellCuts::isFull() const {
    return m_jumps == m_grading.mostCuts || count() > mostParts;
}

bool CellCuts::cutAt(double place) {
    if (isFull() || !add(place)) return false;
    ++m_jumps;
    addGraded(place);
    measure();
    return true;
}

void CellCuts::endPartAt(double place) {
    if (place > 0 && add(place)) measure();
}

void CellCuts::recut(std::span<const WaveCell> cells, const CellCuts& coarse, std::size_t first,
                     std::span<WaveCell> parts) const {
    assert(parts.size() * coarse.count() == cells.size() * count());
    WaveCell* out = parts.data();
    std::size_t part = first;
    auto at = std::lower_bound(m_places.begin(), m_places.end(), coarse.m_places[first]);
    for (const WaveCell& cell : cells) {
        const double start = coarse.m_places[part];
        const double end = part + 1 < coarse.count() ? coarse.m_places[part + 1] : 1;
        auto behind = at + 1;
        while (behind != m_places.end() && *behind < end) ++behind;
        if (behind - at == 1 || cell.spread() == 0) {
            for (; at != behind; ++at) *out++ = cell;
        } else {
            const auto share = [&](auto place) {
                return place == behind ? 1 : (*place - start) / (end - start);
            };
            for (; at != behind; ++at) *out++ = cell.part(share(at), share(at + 1));
        }
        part = part + 1 == coarse.count() ? 0 : part + 1;
        if (at == m_places.end()) at = m_places.begin();
    }
}

void CellCuts::meansOfCells(std::span<const WaveCell> parts, long step, std::span<double> means) const {
    const WaveCell* part = parts.data();
    std::size_t number = Walk(*this, step).part();
    for (double& mean : means) {
        mean = 0;
        for (std::size_t i = 0; i < count(); ++i, number = number + 1 == count() ? 0 : number + 1)
            mean += m_widths[number] / m_cell * (part++)->mean();
    }
}

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
