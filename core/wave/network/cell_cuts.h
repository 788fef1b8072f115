// SPDX-License-Identifier: GPL-3.0-or-later
// Where every cell is cut, so that jumps lie between parts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// How finely cells are cut behind a front, where some quantity follows fast.
struct Grading {
    double first;   ///< how far the fastest rate runs in the first part
    double growth;  ///< of the parts behind it
    int mostCuts;   ///< jumps at most that are followed at a place of their own
    bool operator==(const Grading&) const = default;
};

/// The parts of a cell: in a string whose round trips share a cell a jump stays at its place in every cell.
class CellCuts {
  public:
    CellCuts() = default;
    CellCuts(double cell, const std::vector<double>& rates, const Grading& grading) {
        begin(cell, rates, grading);
    }
    /// Cells of this size [t0] on which quantities follow each other at these rates [1/t0].
    void begin(double cell, const std::vector<double>& rates, const Grading& grading);

    std::size_t count() const { return m_places.size(); }
    /// Where part number i begins, in cells: 0 = places()[0] < … < 1.
    const std::vector<double>& places() const { return m_places; }
    /// How long it is [t0].
    const std::vector<double>& widths() const { return m_widths; }

    /// On a clock that counts parts from a whole cell on, where `step` begins and how long it is [t0].
    double clock(long step) const { return Walk(*this, step).clock(); }
    double width(long step) const { return Walk(*this, step).width(); }

    /// Goes from part to part, without a division for each.
    class Walk {
      public:
        Walk(const CellCuts& cuts, long step) : m_cuts(cuts) {
            const long parts = static_cast<long>(cuts.count());
            m_cell = step >= 0 ? step / parts : -((parts - 1 - step) / parts);
            m_part = static_cast<std::size_t>(step - m_cell * parts);
        }
        std::size_t part() const { return m_part; }
        /// Where the part begins, and how long it is.
        double clock() const {
            return m_cuts.m_cell * (static_cast<double>(m_cell) + m_cuts.m_places[m_part]);
        }
        double width() const { return m_cuts.m_widths[m_part]; }
        void next() {
            if (++m_part < m_cuts.count()) return;
            m_part = 0;
            ++m_cell;
        }

      private:
        const CellCuts& m_cuts;
        long m_cell;
        std::size_t m_part;
    };

    /// Whether there are enough cuts.
    bool isFull() const;
    /// Also cut at this place, and behind it as finely as behind a front. False where that is cut already, or
    /// there are enough cuts.
    bool cutAt(double place);

    /// Also end a part at this place, where no wave bends.
    void endPartAt(double place);

    /// Whole cells in parts that follow each other from part number `first` of `coarse` on, as `parts` of
    /// this, which has all places of those, and count() for every coarse.count() of them.
    void recut(std::span<const WaveCell> cells, const CellCuts& coarse, std::size_t first,
               std::span<WaveCell> parts) const;

    /// Means over whole cells of parts that follow each other from `step` on, one for each count() of them.
    void meansOfCells(std::span<const WaveCell> parts, long step, std::span<double> means) const;

  private:
    bool add(double place);
    void addGraded(double place);
    double stepBehind(double distance) const;
    void measure();

    double m_cell = 1;
    std::vector<double> m_rates;  ///< times cell
    Grading m_grading{};
    int m_jumps = 0;
    std::vector<double> m_places;
    std::vector<double> m_widths;
};

// The cells of time that all round trips share (strings §11).

/// Round trips as whole numbers of cells.
struct CellGrid {
    double cell = 0;               ///< Δ [t0]
    std::vector<long> roundTrips;  ///< of each section: 2 T = roundTrips · Δ
    double rounding = 0;           ///< largest |2 T − roundTrips Δ| [t0]

    /// To cells of half the size.
    void halve();
};

// Both write into a grid that is there, whose memory they use again.

/// The largest cell that divides all round trips to 1e-9 of the longest. False where there is none of at
/// least `leastCell` [t0]: `grid` then is of no use.
bool shareGrid(const std::vector<UniformSection>& sections, double leastCell, CellGrid& grid);

/// Round trips rounded to whole cells of that size, at least one each.
void roundGrid(const std::vector<UniformSection>& sections, double cell, CellGrid& grid);

}  // namespace drillwave
