// SPDX-License-Identifier: GPL-3.0-or-later
// Motion of hammer and string while no contact force acts: check that they stay away from each other and from
// the rock.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/wave/network/cell_cuts.h"
#include "core/wave/network/delay_line.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/problem.h"

namespace drillwave {

/// State of hammer and string at the start of a free flight, in the dimensionless units of Problem
/// (problem.h).
struct FlightStart {
    /// Gap between hammer and string, in units of I0/Zr.
    double faceGap = 0;
    /// Distance between bit and rock, in units of I0/Zr.
    double bitDistance = 0;
    /// Energies of hammer and string [I0²/(Zr t0)].
    double hammerEnergy = 0, stringEnergy = 0;
    /// Whether hammer and string have separated for ever, so that their gap does not matter.
    bool released = false;
};

/// Check that hammer, string and rock stay apart, computed with the means of waves over each cell (time
/// step). Steps of impedance transmit these means in the same way as the waves. The means give the exact
/// positions of the ends after each cell. Within a cell, an end of a body of energy E comes no nearer than
/// √(Δ E/Z) (inequality of Cauchy and Schwarz).
class FreeFlight {
  public:
    /// Returns whether this check applies to the hammer and string of a problem: no section may have a mass,
    /// a loss or attenuation.
    static bool suits(const Problem& problem);

    /// Returns whether hammer, string and rock are so far apart at the start that none can touch another
    /// within a cell (time step) of this size [t0], whatever the waves are.
    static bool isClear(const Problem& problem, double cell, const FlightStart& start);

    /// Starts the check of a free flight, in the same memory. The caller must write the waves by waves()
    /// before staysClear().
    void begin(const Problem& problem, const CellGrid& grid, const FlightStart& start);
    /// Returns the waves in a section that run towards the hammer, as means over each cell (time step) of its
    /// round trip, the oldest first.
    std::span<double> waves(std::size_t section) { return m_lines[section].content(); }

    /// Computes the motion for at least `cells` cells (time steps). Returns false as soon as bodies may have
    /// touched, or after a stop request.
    bool staysClear(double cells, const std::stop_token& stop);
    /// Returns the number of cells (time steps) that were computed since the start of the free flight.
    double gone() const { return m_gone; }

  private:
    struct Margins {
        double face = 0, bit = 0;
    };
    static Margins margins(const Problem& problem, double cell, const FlightStart& start);
    /// Number of cells (time steps) that one node (end of a section) computes before the next node.
    static constexpr std::size_t block = 128;

    bool step(const NodeTurn& turn);
    bool stepFace(const NodeTurn& turn);
    bool stepBit(const NodeTurn& turn);

    double* down(std::size_t section) { return m_downs.data() + section * block; }

    std::size_t m_face = 0;   ///< index of the node between hammer and string
    std::size_t m_count = 0;  ///< number of sections of hammer and string
    double m_cell = 0;
    bool m_released = false;
    std::vector<double> m_impedances;
    /// Reflection coefficient of the joint at the rear end of each section, −1 … 1.
    std::vector<double> m_reflections;
    /// Waves in the sections that run towards the hammer; there may be more entries than are used.
    std::vector<DelayLine<double>> m_lines;
    /// Waves towards the rock over a block of cells, for one section after the other.
    std::vector<double> m_downs;
    std::vector<std::size_t> m_delays;
    std::vector<NodeTurn> m_turns;
    double m_faceGap = 0, m_bitDistance = 0;
    Margins m_margins;
    double m_gone = 0;
};

}  // namespace drillwave
