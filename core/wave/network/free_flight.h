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
    /// Energies of hammer and string at the start of the free flight [I0²/(Zr t0)].
    double hammerEnergy = 0, stringEnergy = 0;
    /// Whether hammer and string have separated for ever, so that their gap does not matter.
    bool released = false;
};

/// Check that hammer, string and rock stay apart. It follows only the mean of each wave over each cell (time
/// step), which is faster than following the waves. The means give the exact positions of the ends after each
/// cell. Within a cell of the width Δ, an end of a body of energy E comes nearer by at most √(Δ E/Z)
/// (inequality of Cauchy and Schwarz).
class FreeFlight {
  public:
    /// Returns whether this check applies to the hammer and string of a problem: no section may have a mass,
    /// a loss or attenuation.
    static bool suits(const Problem& problem);

    /// Returns whether hammer, string and rock are so far apart at the start that none can touch another
    /// within a cell (time step) of this size [t0], whatever the waves are.
    static bool isClear(const Problem& problem, double cell, const FlightStart& start);

    /// Starts the check whether hammer, string and rock stay apart during a free flight. Before staysClear(),
    /// the caller must fill waves() of every section.
    void begin(const Problem& problem, const CellGrid& grid, const FlightStart& start);
    /// Returns the wave towards the hammer in a section, for writing: one mean value [F0] for each cell (time
    /// step) of a round trip, the oldest first.
    std::span<double> waves(std::size_t section) { return m_lines[section].content(); }

    /// Computes the free flight for at least `cells` cells (time steps). Returns false as soon as hammer and
    /// string, or bit and rock, may have touched, or after a stop request.
    bool staysClear(double cells, const std::stop_token& stop);
    /// Returns the number of cells (time steps) that were computed since the start of the free flight.
    double gone() const { return m_gone; }

  private:
    struct Margins {
        double face = 0, bit = 0;
    };
    static Margins margins(const Problem& problem, double cell, const FlightStart& start);
    /// Number of cells (time steps) in a block; a node (end of a section) computes up to so many before the
    /// next node.
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
    /// Waves towards the hammer inside each section, as queues of means over cells (time steps); there may be
    /// more entries than sections.
    std::vector<DelayLine<double>> m_lines;
    /// Mean of the wave towards the rock in each cell (time step) of a block, for one section after the
    /// other.
    std::vector<double> m_downs;
    std::vector<std::size_t> m_delays;
    std::vector<NodeTurn> m_turns;
    double m_faceGap = 0, m_bitDistance = 0;
    Margins m_margins;
    double m_gone = 0;
};

}  // namespace drillwave
