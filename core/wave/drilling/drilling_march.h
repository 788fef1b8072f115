// SPDX-License-Identifier: GPL-3.0-or-later
// Computation of many blows in succession, in which waves and motions continue from blow to blow (drilling
// §6).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/wave/drilling/drilling_problem.h"
#include "core/wave/drilling/lossy_line.h"
#include "core/wave/drilling/rear_node.h"
#include "core/wave/network/bit_node.h"
#include "core/wave/network/joint.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

// Wave loss without loss of momentum: a joint or the attenuation of a section returns what it takes from a
// wave over the time between two blows (drilling §3).

/// Wave loss at one place and in one direction, for waves x in a section of impedance Z:
///
///     out = s x + (1 − s) m,   m' = f (x − m)                                                       (D5)
///
/// s is the amplitude factor of the loss, f the blow frequency, m a mean of earlier waves. A constant wave
/// passes unchanged. The momentum still to be returned is (1 − s) m/f, its energy (1 − s) m²/(f Z).
class ReturnedLoss {
  public:
    ReturnedLoss() = default;
    /// Creates the loss with the amplitude factor s = `passing`, 0 < s ≤ 1, for `frequency` blows per t0.
    ReturnedLoss(double passing, double frequency) : m_passing(passing), m_frequency(frequency) {}

    /// Returns the wave after the loss, over a part of a cell of the given width [t0]. The trapezoidal rule
    /// for m conserves momentum exactly.
    WaveCell pass(const WaveCell& in, double width) {
        const double rate = m_frequency * width, before = m_mean;
        m_mean = (before * (1 - rate / 2) + rate * in.mean()) / (1 + rate / 2);
        WaveCell out = m_passing * in;
        out.c[0] += (1 - m_passing) * 0.5 * (before + m_mean);
        out.c[1] += (1 - m_passing) * 0.5 * (m_mean - before);
        m_lost += width * (in.meanSquare() - out.meanSquare()) -
                  (1 - m_passing) / m_frequency * (m_mean - before) * (m_mean + before);
        return out;
    }

    /// Returns the mean m of earlier waves, in units of F0.
    double mean() const { return m_mean; }
    /// Sets the mean m of earlier waves, in units of F0.
    void setMean(double mean) { m_mean = mean; }
    /// Returns the momentum that is still to be returned, in units of I0.
    double held() const { return (1 - m_passing) * m_mean / m_frequency; }
    /// Returns the energy of the momentum that is still to be returned to the string, times its impedance Z.
    double square() const { return held() * m_mean; }
    /// Returns the energy lost since the first blow, times the impedance Z.
    double lost() const { return m_lost; }

  private:
    double m_passing = 1, m_frequency = 1;
    double m_mean = 0;
    double m_lost = 0;
};

/// State of the rear end of rod or string at the end of a part of a cell, in the dimensionless units of
/// Problem (problem.h).
struct RearSample {
    /// Time since the first blow, in units of t0.
    double time = 0;
    /// Velocity of the rear end, in units of F0/Zr, positive towards the rock.
    double velocity = 0;
    /// Force of the damper on the rear end, in units of F0; ≥ 0 with a machine mass.
    double damperForce = 0;
    /// Position x_b of the machine body towards the rock, in units of I0/Zr. Without a machine mass it is the
    /// position of the rear end.
    double bodyPlace = 0;
};

/// State of the bit at the end of a part of a cell, in the dimensionless units of Problem (problem.h).
struct BitSample {
    /// Time since the first blow, in units of t0; it includes the transit time by which the bit's clock is
    /// late.
    double time = 0;
    /// Impact force, in units of F0; ≥ 0.
    double force = 0;
    /// Penetration below the rock surface that was there before the first blow, in units of I0/Zr.
    double penetration = 0;
    /// Velocity of the bit, in units of F0/Zr, positive towards the rock.
    double velocity = 0;
};

/// Recorded states of the rear end and of the bit over several blows.
struct DrillingSamples {
    std::vector<RearSample> rear;
    std::vector<BitSample> bit;
};

/// Waves of one blow of a sequence and of the interval before it, in which they began. Times are counted from
/// that blow, in units of t0; other units are those of Problem.
struct MarchedWaves {
    /// Waves in all sections; null if they are too many to be kept.
    std::shared_ptr<StringWaves> waves;
    /// Contact events of bit and rock, from the blow before on.
    std::vector<ImpactEvent> events;
    /// Position of the bit relative to the bottom of the crater at the blow; positive into the rock, negative
    /// while apart.
    double place = 0;
    /// Largest force that this blow's rock has felt before, in units of F0.
    double rememberedForce = 0;
    /// Residual penetration by the blows before; 0 on new rock.
    double residual = 0;
    /// Work of the prescribed force, or energy that the hammer transfers, in the blow and the interval after
    /// it.
    double hammerWork = 0;
    /// Work on the rock ∫F dU in the same time, less the work lost with replaced rock.
    double rockWork = 0;
    /// Transit time from the rear end to the bit, as computed with the time step, in units of t0.
    double transitTime = 0;
};

/// Computation of blow after blow in the same memory. Memory and work of a blow do not depend on their
/// number. Every node (end of a section) has its own clock: the bit's clock is behind the rear end's clock by
/// the transit time of the string.
class DrillingMarch {
  public:
    /// Creates the state before the first blow. `problem` must outlive the object.
    DrillingMarch(const DrillingProblem& problem, const DrillingGrid& grid);

    /// Computes one blow and the interval up to the next one. Returns false after a stop request, or if the
    /// computation fails; then see failureReason().
    bool takeBlow(const std::stop_token& stop);
    /// Returns the results of the last blow.
    const DrillingBlow& blow() const { return m_blow; }
    /// Returns the number of blows computed so far.
    long blows() const { return m_count; }
    /// Returns the energy balance of all blows so far.
    const DrillingLedger& ledger() const { return m_ledger; }
    /// Returns the error of the momentum balance over all blows, in units of I0: Σ rock impulse − N Fe/f +
    /// p_end − p_start for N blows. It is due to rounding only.
    double momentumResidual() const;
    /// Returns the impulse of the hammer after its first separation, in the last blow, as a share of its
    /// momentum m_h v0.
    double lateShare() const { return m_lateShare; }
    /// Returns the work of all blows so far, in cells times nodes, including the work of contact events.
    double work() const;
    /// Returns the reason why the computation failed; empty if it did not.
    std::string_view failureReason() const { return m_failureReason; }
    /// Returns the momentum m_h v0 of the hammer, in units of I0; 1 for a prescribed force.
    double hammerMomentum() const { return m_hammerMomentum; }

    /// Sets where the states of rear end and bit are recorded during the following blows; nullptr for no
    /// recording.
    void watch(DrillingSamples* samples) { m_samples = samples; }
    /// Computes one interval and the blow after it, and returns the waves of both. The first blow has no
    /// interval before it. The waves are null if they are too many, the computation fails or a stop is
    /// requested.
    MarchedWaves takeBlowWithWaves(const std::stop_token& stop);

    /// Displaces waves and bit a little, to make a second, slightly different state. approach() then sets the
    /// size of the difference.
    void displace(double distance);
    /// Returns the distance between this state and another one of the same problem, both just before a blow.
    /// It is the root of a sum of squares over waves, position and velocity of the bit, machine velocity, and
    /// the offset x if there is a spring.
    double distanceTo(const DrillingMarch& other) const;
    /// Moves this state towards another one until the given distance remains, as measured by distanceTo().
    void approach(const DrillingMarch& other, double distance);

  private:
    void beginBlow();
    bool flyStep(std::size_t part);
    void step(std::size_t part, const WaveCell* force);
    void addSamples(std::size_t part, const WaveCell& rearVelocity, double damperForce,
                    const WaveCell& arriving);
    double keptClock(std::size_t part) const;
    void addWaves(std::size_t part, const RearNode::Forces& rear);
    void noteGap(const WaveCell& arriving);
    void endBlow();
    double storedEnergy() const;
    double momentum() const;
    double hammerEnergy() const;
    long cellsOfNextInterval();

    const DrillingProblem& m_problem;
    DrillingGrid m_grid;
    /// Number of sections of the hammer.
    std::size_t m_hammer = 0;
    /// Mean interval between blows, in units of t0.
    double m_interval = 1;
    double m_stringMass = 0, m_hammerMomentum = 1, m_hammerMass = 0;
    /// Prescribed force for each part of the cells, from its start on.
    std::vector<WaveCell> m_force;
    std::vector<LossyLine> m_lines;
    /// Joint [j] is in front of section j + 1.
    std::vector<Joint> m_joints;
    RearNode m_rear;
    BitNode m_bit;
    /// Losses at the rear end of each section.
    std::vector<ReturnedLoss> m_downLosses, m_upLosses;
    /// Whether any of these losses is not zero.
    bool m_isWeakened = false;
    /// Waves b that arrive at the rear ends of all sections over a part of a cell.
    std::vector<WaveCell> m_arriving;
    /// Waves of m_arriving after the losses of m_upLosses.
    std::vector<WaveCell> m_returning;
    std::mt19937 m_random;

    long m_count = 0;
    /// Number of whole cells since the first blow.
    long m_cells = 0;
    /// Number of cells in the present interval.
    long m_nextInterval = 1;
    /// Cell of the present interval during which the next blow's time is reached on the bit's clock.
    long m_gapCell = 0;
    std::size_t m_gapPart = 0;  ///< part of cell m_gapCell in which that time is reached
    double m_gapShare = 0;      ///< fraction of part m_gapPart at which that time is reached, 0 … 1
    DrillingBlow m_blow, m_next;
    DrillingLedger m_ledger;
    /// Impulse of the rock in the present interval up to the next blow's time.
    double m_impulseToGap = 0;
    /// Momentum of the string at the time of the blow.
    double m_momentumAtBlow = 0;
    /// Impulse of the rock after that time, within the previous interval.
    double m_impulseCarriedOver = 0;
    /// Impulse J of the hammer in the previous interval.
    double m_lastImpulse = 0;
    double m_startMomentum = 0, m_rockImpulse = 0, m_fed = 0;
    double m_storedBefore = 0;
    /// Energy lost by waves inside all hammers so far [F0² t0/Zr].
    double m_hammerLost = 0;
    double m_lateShare = 0;
    double m_holeDepth = 0;
    double m_rearPlace = 0;  ///< position x_r of the rear end at the blow
    double m_rearMoved = 0;  ///< displacement of the rear end since the blow
    double m_stringTransit = 0;
    long m_cell = 0;  ///< index of the present cell within the interval
    std::string_view m_failureReason;
    DrillingSamples* m_samples = nullptr;
    MarchedWaves* m_kept = nullptr;
    /// Number of cells from the first blow until the clock of the recorded waves reads zero.
    long m_keptCell = 0;
    /// Waves that enter each section over a part of a cell.
    std::vector<WaveCell> m_downs, m_backs;
    /// Position of the bit at the next blow, relative to the bottom of the crater.
    double m_nextPlace = 0;
};

}  // namespace drillwave
