// SPDX-License-Identifier: GPL-3.0-or-later
// Computation of a blow on a drill string to its end (strings §8, §11).
#pragma once

#include <optional>
#include <stop_token>
#include <string_view>

#include "core/text/message.h"
#include "core/wave/impact.h"
#include "core/wave/network/cell_lattice.h"
#include "core/wave/network/census.h"
#include "core/wave/network/free_flight.h"
#include "core/wave/network/march_plan.h"
#include "core/wave/network/wave_recorder.h"

namespace drillwave {

/// Computation of a blow in blocks of time steps, up to its time limit or the proof that the string touches
/// neither rock nor hammer again. One blow after another can be computed in the same memory. If only
/// integrals over the blow are requested, a blow no larger than earlier ones allocates no memory. The object
/// cannot be moved, because its members point to each other.
class NetworkMarch {
  public:
    NetworkMarch() = default;
    NetworkMarch(const NetworkMarch&) = delete;
    NetworkMarch& operator=(const NetworkMarch&) = delete;

    /// Plans the computation of a blow for run(), and returns its estimated work; allocates no memory for
    /// waves.
    const ForeseenWork& plan(const Problem& problem, const CellGrid& grid, const NetworkWants& wants);
    /// Returns the result of the blow that plan() has prepared. The work is limited to `mostCells`, in cells
    /// (time steps) times nodes (ends of sections); a blow that needs more is not solved.
    Impact run(long mostCells, const std::stop_token& stop);
    /// Returns the number of cells (waves over one time step) that were stored for all sections at the end of
    /// the blow.
    double held() const { return m_lattice.held(); }

  private:
    void begin(long mostCells);
    void scheduleCensus();
    void countBlock(const std::stop_token& stop);
    std::optional<Impact> endOfBlow(const std::stop_token& stop);
    bool isUntouchedSince(const CensusResult& census) const;
    bool fliesUntil(double time, const std::stop_token& stop);
    Impact result(const CensusResult& census, Outcome outcome);
    Impact notSolved(Message reason, Hindrance hindrance);
    const char* workLimitReason() const;
    long flownCells() const;
    long work() const;

    MarchPlan m_plan;
    CellLattice m_lattice;
    WaveRecorder m_recorder;
    StringCensus m_census;
    FreeFlight m_flight;
    long m_cells = 0;
    /// Work of all checks of free flight so far, in means of cells (time steps) times nodes (ends of
    /// sections).
    double m_flown = 0;
    /// Momentum, energy and state at the last time when hammer, string and rock were found to be apart; empty
    /// if they have touched since.
    std::optional<CensusResult> m_free;
    /// Clock reading [t0] up to which hammer, string and rock certainly stay apart.
    double m_landing = 0;
};

}  // namespace drillwave
