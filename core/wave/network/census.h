// SPDX-License-Identifier: GPL-3.0-or-later
// All that moves at one time: momentum, energy, penetration, gap.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/wave/network/bit_node.h"
#include "core/wave/network/face_node.h"
#include "core/wave/network/joint.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Integrals of one wave of a section: over its past in the section, and over its present content.
struct LineSums {
    double passed = 0, passedSquare = 0;    ///< ∫ and ∫² of the part that has left, as it entered
    double entered = 0, enteredSquare = 0;  ///< of the content, as it entered
    double present = 0, presentSquare = 0;  ///< of the content, as it is now
};

/// The sums over one wave between two clock times while cells go by.
class LineCensus {
  public:
    /// Sums up the line at the clock `to`, filled since `from`; it loses `decay` of the logarithm of its
    /// amplitude over that time. Before clock 0 the wave was `before`.
    LineCensus(double from, double to, double decay, double before);

    /// Returns whether cells between two clock times matter; earlier ones do only if something is lost.
    bool concerns(double start, double end, bool losses) const {
        return start < m_to && (losses || end > m_from);
    }
    /// Adds a cell that enters at clock `start`.
    void add(const WaveCell& cell, double start, double width) {
        if (start >= m_to) return;
        if (start + width <= m_from) {
            m_sums.passed += width * cell.mean();
            m_sums.passedSquare += width * cell.meanSquare();
        } else if (start >= m_from && start + width <= m_to && m_decay == 0) {
            m_sums.entered += width * cell.mean();
            m_sums.enteredSquare += width * cell.meanSquare();
            m_sums.present = m_sums.entered;
            m_sums.presentSquare = m_sums.enteredSquare;
        } else {
            addAcross(cell, start, width);
        }
    }
    /// Sets the part entered by `to` of the cell that begins at clock `start`. A cell only has the moments of
    /// its wave as a whole: a part of it has others.
    void setEntered(const WaveCell& part, double start) { m_entered = {part, start}; }
    const LineSums& sums() const { return m_sums; }

  private:
    void addAcross(const WaveCell& cell, double start, double width);

    double m_from, m_to, m_decay;
    LineSums m_sums;
    struct Entered {
        WaveCell part;
        double start;
    };
    std::optional<Entered> m_entered;
};

/// Motions and energies at one time, over the whole string. Units of Problem.
struct CensusResult {
    double time = 0;
    BitNodeState bit = {};
    FaceNodeState face = {};
    double hammerMomentum = 0, hammerEnergy = 0;
    double stringMomentum = 0, stringEnergy = 0;
    double jointLoss = 0, rodLoss = 0, externalMomentum = 0;
    double faceEnergy = 0;
};

// Census of hammer and string at one time, taken during the march.

/// Clocks of a string: at every place, the clock of the face less the travel time to it.
struct StringClocks {
    /// Sets the clocks of a string whose sections take these times one way [t0].
    void begin(std::size_t hammerSections, const std::vector<double>& transitTimes);

    std::vector<double> delays;  ///< of node i: time = clock + delays[i]; below 0 in the hammer
    std::vector<double> transitTimes;
    double earliest() const { return delays.front(); }
    double bit() const { return delays.back(); }
};

/// Momentum and energy of everything at `time`, complete when every node has passed it. Takes one census
/// after another in the same memory.
class StringCensus {
  public:
    /// `problem` and `clocks` must outlive it.
    void begin(const Problem& problem, const StringClocks& clocks, double time);
    /// Whether it is between begin() and finish(). All else requires that.
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
    /// Sets the velocity of the mass after section `j`.
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

/// Returns the time from which a string without losses cannot meet rock or hammer again, provided that it
/// meets neither between the census and that time (strings §8). Nothing where it is unknown.
std::optional<double> restTime(const Problem& problem, const CensusResult& census);

}  // namespace drillwave
