// SPDX-License-Identifier: GPL-3.0-or-later
// Where every cell is cut, so that jumps lie between parts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Fineness of cells behind a front, where some quantity follows fast.
struct Grading {
    double first;   ///< width of the first part times the fastest rate
    double growth;  ///< of each part relative to the one before
    int mostCuts;   ///< maximum number of jumps that get a place of their own
    bool operator==(const Grading&) const = default;
};

/// Parts of a cell: in a string whose round trips share a cell, a jump stays at its place in every cell.
class CellCuts {
  public:
    CellCuts() = default;
    CellCuts(double cell, const std::vector<double>& rates, const Grading& grading) {
        begin(cell, rates, grading);
    }
    /// Starts cells of this size [t0] on which quantities follow each other at these rates [1/t0].
    void begin(double cell, const std::vector<double>& rates, const Grading& grading);

    std::size_t count() const { return m_places.size(); }
    /// Returns where each part begins, in cells: 0 = places()[0] < … < 1.
    const std::vector<double>& places() const { return m_places; }
    /// Returns the length of each part [t0].
    const std::vector<double>& widths() const { return m_widths; }

    /// Return the start and width of `step` [t0], on a clock that counts parts from a whole cell on.
    double clock(long step) const { return Walk(*this, step).clock(); }
    double width(long step) const { return Walk(*this, step).width(); }

    /// Walks from part to part, without a division for each.
    class Walk {
      public:
        Walk(const CellCuts& cuts, long step) : m_cuts(cuts) {
            const long parts = static_cast<long>(cuts.count());
            m_cell = step >= 0 ? step / parts : -((parts - 1 - step) / parts);
            m_part = static_cast<std::size_t>(step - m_cell * parts);
        }
        std::size_t part() const { return m_part; }
        /// Return start and width of the part.
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

    /// Returns whether there are enough cuts.
    bool isFull() const;
    /// Also cuts at this place, and after it as finely as after a front. Returns false if that is cut
    /// already, or if there are enough cuts.
    bool cutAt(double place);

    /// Also ends a part at this place, where no wave bends.
    void endPartAt(double place);

    /// Splits whole cells, in consecutive parts from part number `first` of `coarse` on, into `parts` of
    /// this, which has all places of `coarse`: count() for every coarse.count() of them.
    void recut(std::span<const WaveCell> cells, const CellCuts& coarse, std::size_t first,
               std::span<WaveCell> parts) const;

    /// Writes means over whole cells of consecutive parts from `step` on, one for each count() of them.
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

    /// Halves the size of the cells.
    void halve();
};

// Both write into a grid that is there, whose memory they use again.

/// The largest cell that divides all round trips to 1e-9 of the longest. False where there is none of at
/// least `leastCell` [t0]: `grid` then is of no use.
bool shareGrid(const std::vector<UniformSection>& sections, double leastCell, CellGrid& grid);

/// Round trips rounded to whole cells of that size, at least one each.
void roundGrid(const std::vector<UniformSection>& sections, double cell, CellGrid& grid);

}  // namespace drillwave
