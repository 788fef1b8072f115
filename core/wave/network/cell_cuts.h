// SPDX-License-Identifier: GPL-3.0-or-later
// Points within a cell (time step) at which every cell is cut, so that jumps of waves lie between its parts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Rule that divides a cell (time step) into finer parts after a wave front, where forces change fast.
struct Grading {
    /// Width of the first part after a wave front, times the fastest rate of the differential equations;
    /// dimensionless.
    double first;
    /// Ratio of the width of each part of a cell to that of the part before; ≥ 1.
    double growth;
    /// Maximum number of wave fronts for which cells (time steps) are cut.
    int mostCuts;
    bool operator==(const Grading&) const = default;
};

/// Division of every cell (time step) into parts. If all round trips of the string are whole numbers of
/// cells, a jump of a wave is at the same point of every cell. So all cells are divided at the same points.
class CellCuts {
  public:
    CellCuts() = default;
    /// Creates cells (time steps) of the size `cell` [t0], divided only after their start; the arguments are
    /// those of begin().
    CellCuts(double cell, const std::vector<double>& rates, const Grading& grading) {
        begin(cell, rates, grading);
    }
    /// Starts with cells of the size `cell` [t0], divided only after their start, where a wave front is
    /// assumed. `rates` are the rate constants of the differential equations [1/t0]. Together with `grading`
    /// they decide how finely a cell is divided after a wave front.
    void begin(double cell, const std::vector<double>& rates, const Grading& grading);

    /// Returns the number of parts of each cell (time step); 1 if cells are not divided.
    std::size_t count() const { return m_places.size(); }
    /// Returns the position in the cell at which each part begins, as a fraction of the cell: 0 = places()[0]
    /// < … < 1.
    const std::vector<double>& places() const { return m_places; }
    /// Returns the width of each part of a cell (time step), in units of t0.
    const std::vector<double>& widths() const { return m_widths; }

    /// Returns the time at which a time step (part of a cell) starts, in units of t0. `step` counts the parts
    /// of all cells from the cell that starts at the time 0, and may be negative.
    double clock(long step) const { return Walk(*this, step).clock(); }
    /// Returns the width of a time step (part of a cell), in units of t0. `step` counts the parts of all
    /// cells from the cell that starts at the time 0, and may be negative.
    double width(long step) const { return Walk(*this, step).width(); }

    /// Iterator over consecutive parts of cells (time steps), which gives the start and width of each part.
    class Walk {
      public:
        /// Starts at the part with the number `step`, counted from the start of the cell (time step) at the
        /// time 0.
        Walk(const CellCuts& cuts, long step) : m_cuts(cuts) {
            const long parts = static_cast<long>(cuts.count());
            m_cell = step >= 0 ? step / parts : -((parts - 1 - step) / parts);
            m_part = static_cast<std::size_t>(step - m_cell * parts);
        }
        /// Returns the index of the present part within its cell (time step), from 0.
        std::size_t part() const { return m_part; }
        /// Returns the time at which the present part of a cell (time step) starts, in units of t0.
        double clock() const {
            return m_cuts.m_cell * (static_cast<double>(m_cell) + m_cuts.m_places[m_part]);
        }
        /// Returns the width of the present part of a cell (time step), in units of t0.
        double width() const { return m_cuts.m_widths[m_part]; }
        /// Advances to the next part of the cell (time step), or to the first part of the next cell.
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

    /// Returns whether cells can be divided no further, because Grading::mostCuts or the maximum number of
    /// parts is reached.
    bool isFull() const;
    /// Cuts every cell at `place` (a fraction of the cell), and divides the cell after it as finely as after
    /// a wave front. Returns false and changes nothing if cells are cut there already, or if isFull().
    bool cutAt(double place);

    /// Cuts every cell at `place` (a fraction of the cell), so that a part ends there. No wave bends there,
    /// so no finer parts are added.
    void endPartAt(double place);

    /// Converts a wave from the coarser division `coarse` to this division, which must contain all points of
    /// `coarse`. `cells` holds the wave over whole cells (time steps), as consecutive parts of `coarse`, from
    /// its part number `first` on. `parts` receives count() entries for every coarse.count() entries of
    /// `cells`.
    void recut(std::span<const WaveCell> cells, const CellCuts& coarse, std::size_t first,
               std::span<WaveCell> parts) const;

    /// Writes the mean of a wave over each whole cell (time step) to `means`. `parts` holds the wave over
    /// consecutive parts of cells, count() parts for each mean. `step` is the number of the first part.
    void meansOfCells(std::span<const WaveCell> parts, long step, std::span<double> means) const;

  private:
    bool add(double place);
    void addGraded(double place);
    double stepBehind(double distance) const;
    void measure();

    double m_cell = 1;
    std::vector<double> m_rates;  ///< rates [1/t0] times the size of a cell
    Grading m_grading{};
    int m_jumps = 0;
    std::vector<double> m_places;
    std::vector<double> m_widths;
};

// Cells (time steps) of which all round trips are whole multiples (strings §11).

/// Round trips of all sections as whole numbers of cells (time steps).
struct CellGrid {
    /// Size Δ of a cell (time step), in units of t0.
    double cell = 0;
    /// Round trip of each section as a number of cells (time steps): 2T = roundTrips · Δ.
    std::vector<long> roundTrips;
    /// Largest rounding error of a round trip, |2T − roundTrips · Δ|, in units of t0.
    double rounding = 0;

    /// Halves the size Δ of the cells and doubles the number of cells in each round trip.
    void halve();
};

// Both functions write to the given grid and reuse its memory.

/// Writes the largest time step (cell) of which all round trips are whole multiples, to 1e-9 of the longest
/// one. Returns false if that step would be smaller than `leastCell` [t0]; the content of `grid` is then
/// invalid.
bool shareGrid(const std::vector<UniformSection>& sections, double leastCell, CellGrid& grid);

/// Rounds all round trips to whole numbers of cells of the size `cell` [t0], at least one each, and writes
/// them to `grid`.
void roundGrid(const std::vector<UniformSection>& sections, double cell, CellGrid& grid);

}  // namespace drillwave
