// SPDX-License-Identifier: GPL-3.0-or-later
// The census of hammer and string at one time, taken while the march goes by.
#pragma once

#include <optional>
#include <vector>

#include "core/wave/network/census.h"
#include "core/wave/network/joint.h"
#include "core/wave/problem.h"

namespace drillwave {

/// A place of the string whose clock is that of the face less the way to it.
struct StringClocks {
    /// Of a string whose sections take these times one way [t0].
    void begin(std::size_t hammerSections, const std::vector<double>& transitTimes);

    std::vector<double> delays;  ///< of node i: time = clock + delays[i]; below 0 in the hammer
    std::vector<double> transitTimes;
    double earliest() const { return delays.front(); }
    double bit() const { return delays.back(); }
};

/// Momentum and energy of everything at `time`, complete when every node has passed it. One after another, in
/// the same memory.
class StringCensus {
  public:
    /// `problem` and `clocks` must outlive it.
    void begin(const Problem& problem, const StringClocks& clocks, double time);
    /// From begin() to finish(). The rest only then.
    bool isUnderWay() const { return m_isUnderWay; }
    void abandon() { m_isUnderWay = false; }

    double time() const { return m_result.time; }
    /// The clock at which the last node has passed.
    double lastClock() const { return m_result.time - m_clocks->earliest(); }
    /// The time on the clock of a node.
    double clockOf(std::size_t node) const { return m_result.time - m_clocks->delays[node]; }

    /// Waves of section `j` at its rear end, and at its front end.
    LineCensus& down(std::size_t j) { return m_down[j]; }
    LineCensus& up(std::size_t j) { return m_up[j]; }
    void setBit(const BitNodeState& bit) { m_result.bit = bit; }
    void setFace(const FaceNodeState& face) { m_result.face = face; }
    /// The velocity of the mass behind section `j`.
    void setMassVelocity(std::size_t j, double velocity) { m_massVelocities[j] = velocity; }

    /// The sums, once lastClock() is passed.
    CensusResult finish();

  private:
    const Problem* m_problem = nullptr;
    const StringClocks* m_clocks = nullptr;
    bool m_isUnderWay = false;
    std::vector<LineCensus> m_down, m_up;
    std::vector<double> m_massVelocities;
    CensusResult m_result;
};

/// The time from which on neither the rock nor the hammer can be met again by a string that loses nothing,
/// provided that neither is met between the census and then (strings §8). Nothing where that cannot be told.
std::optional<double> restTime(const Problem& problem, const CensusResult& census);

}  // namespace drillwave
