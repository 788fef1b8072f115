// SPDX-License-Identifier: GPL-3.0-or-later
// Hammer and string while nothing touches them: whether they stay away from each other and from the rock.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/delay_line.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/problem.h"

namespace drillwave {

/// State of hammer and string at the beginning of a flight.
struct FlightStart {
    double faceGap = 0;      ///< between hammer and string
    double bitDistance = 0;  ///< between bit and rock
    double hammerEnergy = 0, stringEnergy = 0;
    bool released = false;  ///< whether the hammer does not matter any more
};

/// Sections that end in steps of impedance only transmit the means of their waves over a cell like the waves,
/// which give the exact places of the ends after each cell. Within a cell neither end gets nearer than at its
/// ends by more than √(Δ E/Z), by the inequality of Cauchy and Schwarz, E the energy of its body.
class FreeFlight {
  public:
    /// Returns whether flights of a string can be followed: requires joints without mass or loss.
    static bool suits(const Problem& problem);

    /// Returns whether distances are so large that nothing can touch, whatever the waves are.
    static bool isClear(const Problem& problem, double cell, const FlightStart& start);

    /// Begins a flight in the same memory. Its waves must be written before it goes on.
    void begin(const Problem& problem, const CellGrid& grid, const FlightStart& start);
    /// Means of the cells of a section on their way back, the oldest first, as many as its round trip has.
    std::span<double> waves(std::size_t section) { return m_lines[section].content(); }

    /// Continues for at least that many cells. False as soon as something may have touched, or after a stop.
    bool staysClear(double cells, const std::stop_token& stop);
    /// Cells that it went.
    double gone() const { return m_gone; }

  private:
    struct Margins {
        double face = 0, bit = 0;
    };
    static Margins margins(const Problem& problem, double cell, const FlightStart& start);
    /// Cells taken by one node before the next one follows.
    static constexpr std::size_t block = 128;

    bool step(const NodeTurn& turn);
    bool stepFace(const NodeTurn& turn);
    bool stepBit(const NodeTurn& turn);

    double* down(std::size_t section) { return m_downs.data() + section * block; }

    std::size_t m_face = 0;   ///< number of the node
    std::size_t m_count = 0;  ///< of sections
    double m_cell = 0;
    bool m_released = false;
    std::vector<double> m_impedances;
    std::vector<double> m_reflections;       ///< of the node in front of section j
    std::vector<DelayLine<double>> m_lines;  ///< of sections; there may be more than are used
    std::vector<double> m_downs;             ///< waves down over a block, of one section after the other
    std::vector<std::size_t> m_delays;
    std::vector<NodeTurn> m_turns;
    double m_faceGap = 0, m_bitDistance = 0;
    Margins m_margins;
    double m_gone = 0;
};

}  // namespace drillwave
