// SPDX-License-Identifier: GPL-3.0-or-later
// Momentum, energy and state of hammer, string and rock at one time.
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

/// Integrals of a wave f over time, at one instant: over the part that has already left a section, and over
/// the part inside it.
struct LineSums {
    /// Integrals ∫f dt [I0] and ∫f² dt [F0² t0] over the part of the wave f that has already left the
    /// section. f is taken where it entered, before attenuation.
    double passed = 0, passedSquare = 0;
    /// Integrals ∫f dt [I0] and ∫f² dt [F0² t0] over the part of the wave f that is inside the section. f is
    /// taken where it entered, before attenuation.
    double entered = 0, enteredSquare = 0;
    /// Integrals ∫f dt [I0] and ∫f² dt [F0² t0] over the part of the wave f that is inside the section, with
    /// its present, attenuated amplitude.
    double present = 0, presentSquare = 0;
};

/// Accumulator of the integrals over one wave of a section, to which the cells (time steps) of the wave are
/// added one by one.
class LineCensus {
  public:
    /// Creates the integrals of a wave in a section at one instant. The clock where the wave enters then
    /// reads `to`, and the section contains the wave that entered from `from` to `to` [t0]. `decay` is the
    /// attenuation αL over one transit. `before` is the constant value of the wave before the clock reading
    /// 0.
    LineCensus(double from, double to, double decay, double before);

    /// Returns whether cells (time steps of the wave) that enter the section from `start` to `end` contribute
    /// to the integrals. Cells that have left the section count only if `losses` says that joints or sections
    /// lose energy.
    bool concerns(double start, double end, bool losses) const {
        return start < m_to && (losses || end > m_from);
    }
    /// Adds a cell (time step) of the wave, of the given width, that enters the section at the clock time
    /// `start`, in units of t0.
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
    /// Sets the exact wave over the first part of the cell (time step) that begins at `start`, up to the
    /// clock time `to` of the constructor. It is used instead of the cubic of that cell, whose moments are
    /// exact only over the whole cell.
    void setEntered(const WaveCell& part, double start) { m_entered = {part, start}; }
    /// Returns the integrals ∫f dt [I0] and ∫f² dt [F0² t0] over all cells (time steps) of the wave f added
    /// so far.
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

/// Momentum, energy and state of hammer, string and rock at one time. Units are the dimensionless ones of
/// Problem (problem.h): time t0, force F0, impulse I0 = F0 t0, energy I0²/(Zr t0).
struct CensusResult {
    /// Time to which all members of this state refer, in units of t0.
    double time = 0;
    /// State of bit and rock at `time`.
    BitNodeState bit = {};
    /// State of the contact between hammer and string at `time`.
    FaceNodeState face = {};
    /// Momentum [I0] and energy [I0²/(Zr t0)] of the hammer.
    double hammerMomentum = 0, hammerEnergy = 0;
    /// Momentum [I0] and energy [I0²/(Zr t0)] of the string.
    double stringMomentum = 0, stringEnergy = 0;
    /// Energy [I0²/(Zr t0)] lost so far in joints and in sections, and momentum [I0] lost in both.
    double jointLoss = 0, rodLoss = 0, externalMomentum = 0;
    /// Elastic energy in the contact stiffness of the hammer face [I0²/(Zr t0)].
    double faceEnergy = 0;
};

// Sums over hammer and string at one time, taken while the blow is computed

/// Clocks of the nodes (ends of sections). The clock of a node reads the time minus the travel time of a wave
/// from the hammer face to the node, which counts as negative inside the hammer.
struct StringClocks {
    /// Sets the delays of all clocks. `transitTimes` are the one-way transit times of the sections, in units
    /// of t0; the first `hammerSections` of them belong to the hammer.
    void begin(std::size_t hammerSections, const std::vector<double>& transitTimes);

    /// Delay of the clock of each node (end of a section): time = clock + delays[i], in units of t0. It is
    /// negative in the hammer.
    std::vector<double> delays;
    /// One-way transit time of each section, in units of t0.
    std::vector<double> transitTimes;
    /// Returns the delay of the clock at the rear end of the hammer, in units of t0; it is the smallest of
    /// all clocks and ≤ 0.
    double earliest() const { return delays.front(); }
    /// Returns the delay of the clock at the bit, in units of t0; it is the largest of all clocks.
    double bit() const { return delays.back(); }
};

/// Sums of momentum and energy over hammer, string and rock at one time. They are complete when the clock of
/// every node (end of a section) has passed that time. One sum after another can be taken in the same memory.
class StringCensus {
  public:
    /// Starts a new sum of momentum and energy for the time `time`, in units of t0. `problem` and `clocks`
    /// must outlive it.
    void begin(const Problem& problem, const StringClocks& clocks, double time);
    /// Returns whether begin() has started a sum that neither finish() nor abandon() has ended. All functions
    /// except begin() and abandon() require this.
    bool isUnderWay() const { return m_isUnderWay; }
    /// Ends the present sum of momentum and energy without a result.
    void abandon() { m_isUnderWay = false; }

    /// Returns the time for which momentum and energy are summed, in units of t0.
    double time() const { return m_result.time; }
    /// Returns the clock reading [t0] after which the sum is complete, because all nodes (ends of sections)
    /// have passed its time. The clock of a node reads the time minus the delay of this node.
    double lastClock() const { return m_result.time - m_clocks->earliest(); }
    /// Returns the clock reading of a node (end of a section) at the time for which momentum and energy are
    /// summed, in units of t0.
    double clockOf(std::size_t node) const { return m_result.time - m_clocks->delays[node]; }

    /// Returns the integrals of the wave towards the rock in section `j`, to which its time steps are added.
    /// The wave enters at the rear end.
    LineCensus& down(std::size_t j) { return m_down[j]; }
    /// Returns the integrals of the wave away from the rock in section `j`, to which its time steps are
    /// added. The wave enters at the front end.
    LineCensus& up(std::size_t j) { return m_up[j]; }
    /// Sets the state of bit and rock at the time for which momentum and energy are summed.
    void setBit(const BitNodeState& bit) { m_result.bit = bit; }
    /// Sets the state of the hammer face at the time for which momentum and energy are summed.
    void setFace(const FaceNodeState& face) { m_result.face = face; }
    /// Sets the velocity of the lumped mass at the front end of section `j`, in units of F0/Zr.
    void setMassVelocity(std::size_t j, double velocity) { m_massVelocities[j] = velocity; }

    /// Returns the completed sums of momentum and energy, and ends them. Requires that the clocks have passed
    /// lastClock().
    CensusResult finish();

  private:
    const Problem* m_problem = nullptr;
    const StringClocks* m_clocks = nullptr;
    bool m_isUnderWay = false;
    std::vector<LineCensus> m_down, m_up;
    std::vector<double> m_massVelocities;
    CensusResult m_result;
};

/// Returns the time t/t0 from which a string without losses certainly touches neither rock nor hammer again
/// (strings §8). This assumes that it touches neither from the time of `census` to that time. Returns nullopt
/// if that time is unknown.
std::optional<double> restTime(const Problem& problem, const CensusResult& census);

}  // namespace drillwave
