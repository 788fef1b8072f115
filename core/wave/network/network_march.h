// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a drill string, followed to its end (strings §8, §11).
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

/// Takes blocks of steps until the motion can be counted and neither rock nor hammer is met again. Follows
/// one blow after another in the same memory: if only sums are requested, a blow no larger than those before
/// allocates nothing. Its parts point to each other, so it cannot be moved.
class NetworkMarch {
  public:
    NetworkMarch() = default;
    NetworkMarch(const NetworkMarch&) = delete;
    NetworkMarch& operator=(const NetworkMarch&) = delete;

    /// Returns the estimated work; uses no memory for waves yet.
    const ForeseenWork& plan(const Problem& problem, const CellGrid& grid, const NetworkWants& wants);
    /// Follows the blow that was planned last, with at most `mostCells` cells × nodes of work.
    Impact run(long mostCells, const std::stop_token& stop);
    static constexpr std::string_view tooManyCells = translatable(
        "it takes more wave cells than permitted: try fewer sections, lengths with a common divisor or a "
        "shorter end_time");
    /// Cells on their way at the end of the blow.
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
    std::string_view workLimitReason() const;
    long flownCells() const;
    long work() const;

    MarchPlan m_plan;
    CellLattice m_lattice;
    WaveRecorder m_recorder;
    StringCensus m_census;
    FreeFlight m_flight;
    long m_cells = 0;
    double m_flown = 0;                  ///< cells times nodes of free flights
    std::optional<CensusResult> m_free;  ///< when hammer, string and rock were apart, as they are since then
    double m_landing = 0;                ///< clock before which they are known to stay so, but no longer
};

}  // namespace drillwave
