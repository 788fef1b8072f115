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

// Wave loss without loss of momentum: a joint, or the attenuation of a section, returns the momentum that it
// takes from a wave over the time between two blows (drilling §3).

/// Loss of amplitude of waves that pass one point of a section of impedance Z in one direction. The momentum
/// that is taken from a wave returns later. For an incoming wave x, the wave `out` after the loss is:
///
///     out = s x + (1 − s) m,   m' = f (x − m)                                                       (D5)
///
/// s is the amplitude factor of the loss, f the blow frequency, m a mean of earlier waves. A constant wave
/// passes unchanged. The momentum still to be returned is (1 − s) m/f, its energy (1 − s) m²/(f Z).
class ReturnedLoss {
  public:
    ReturnedLoss() = default;
    /// Creates a loss that multiplies the amplitude of a wave by s = `passing`, 0 < s ≤ 1. `frequency` is the
    /// number of blows per t0.
    ReturnedLoss(double passing, double frequency) : m_passing(passing), m_frequency(frequency) {}

    /// Returns the wave after the loss over one time step (a cell or a part of one) of the given width [t0].
    /// `in` is the incoming wave. The mean m is updated by the trapezoidal rule, which conserves momentum
    /// exactly.
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

    /// Returns the mean m of earlier waves, to which the wave after the loss tends, in units of F0.
    double mean() const { return m_mean; }
    /// Sets the mean m of earlier waves, in units of F0, to start from a given motion of the string.
    void setMean(double mean) { m_mean = mean; }
    /// Returns the momentum that was taken from passing waves and will still be returned to the string, in
    /// units of I0.
    double held() const { return (1 - m_passing) * m_mean / m_frequency; }
    /// Returns the energy (1 − s) m²/(f Z) of the momentum that is still to be returned to the string,
    /// multiplied by the impedance Z of the section.
    double square() const { return held() * m_mean; }
    /// Returns the energy that waves have lost here since the first blow, multiplied by the impedance Z of
    /// the section, in units of F0² t0.
    double lost() const { return m_lost; }

  private:
    double m_passing = 1, m_frequency = 1;
    double m_mean = 0;
    double m_lost = 0;
};

/// State of the rear end of rod or string at the end of a time step, in the dimensionless units of Problem
/// (problem.h).
struct RearSample {
    /// Time since the first blow, in units of t0.
    double time = 0;
    /// Velocity of the rear end, in units of F0/Zr, positive towards the rock.
    double velocity = 0;
    /// Force of the damper on the rear end, in units of F0; ≥ 0 with a machine body. Without one it is the
    /// constant feed force, which may be negative.
    double damperForce = 0;
    /// Position x_b of the machine body, in units of I0/Zr, positive towards the rock. Without a machine it
    /// is the position of the rear end.
    double bodyPlace = 0;
};

/// State of the bit at the end of a time step, in the dimensionless units of Problem (problem.h).
struct BitSample {
    /// Time since the first blow, in units of t0. In each step, the bit is computed at a later time than the
    /// rear end, by the transit time of the string. This delay is included.
    double time = 0;
    /// Impact force, in units of F0; ≥ 0.
    double force = 0;
    /// Penetration of the bit, in units of I0/Zr, below the rock surface that was there before the first
    /// blow.
    double penetration = 0;
    /// Velocity of the bit, in units of F0/Zr, positive towards the rock.
    double velocity = 0;
};

/// Recorded states of the rear end and of the bit over several blows, one for each time step.
struct DrillingSamples {
    std::vector<RearSample> rear;
    std::vector<BitSample> bit;
};

/// Waves in rod or string during one blow of a sequence and the blow before it, each with the interval up to
/// the next blow. Times are counted from the later blow, in units of t0; other units are those of Problem.
struct MarchedWaves {
    /// Waves in all sections; null if they are too many to be stored.
    std::shared_ptr<StringWaves> waves;
    /// Contact events of bit and rock in order of time, during the previous blow and this one.
    std::vector<ImpactEvent> events;
    /// Position of the bit relative to the bottom of the crater at the start of the blow, in units of I0/Zr;
    /// positive into the rock, negative if bit and rock are apart.
    double place = 0;
    /// Largest force that the rock under the bit has carried before this blow, in units of F0. The law of the
    /// rock needs it for reloading.
    double rememberedForce = 0;
    /// Residual penetration that earlier blows have left in the rock under the bit, in units of I0/Zr; 0 on
    /// new rock.
    double residual = 0;
    /// Work of the prescribed force, or energy that the hammer transfers, in the blow and the interval after
    /// it, in units of I0²/(Zr t0).
    double hammerWork = 0;
    /// Work on the rock ∫F dU in the blow and the interval after it, in units of I0²/(Zr t0). The elastic
    /// energy of compressed rock that was replaced by new rock is subtracted.
    double rockWork = 0;
    /// Transit time of the string from the rear end to the bit, rounded as in the computation, in units of
    /// t0.
    double transitTime = 0;
};

/// Computation of blow after blow in the same memory. Memory, and work for each blow, do not depend on the
/// number of blows. In one step, every node (end of a section) is computed at the time at which a wave from
/// the rear end reaches it. The bit is therefore ahead of the rear end by the transit time of the string.
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
    /// Returns the error of the momentum balance over all N blows, in units of I0: Σ rock impulse − N Fe/f +
    /// p_end − p_start. p is the momentum of machine and string, Fe the feed force, f the blow frequency. The
    /// error is due to rounding only.
    double momentumResidual() const;
    /// Returns the impulse that the hammer transferred to the string after their first separation in the last
    /// blow, as a share of its momentum m_h v0.
    double lateShare() const { return m_lateShare; }
    /// Returns the computing work of all blows so far: the number of cells (time steps) times the number of
    /// nodes (ends of sections), plus the work for contact events.
    double work() const;
    /// Returns the reason why the computation failed; empty if it did not.
    std::string_view failureReason() const { return m_failureReason; }
    /// Returns the momentum m_h v0 of the hammer, in units of I0; 1 for a prescribed force.
    double hammerMomentum() const { return m_hammerMomentum; }

    /// Sets the lists to which takeBlow() appends the states of rear end and bit in each time step. nullptr
    /// stops the recording.
    void watch(DrillingSamples* samples) { m_samples = samples; }
    /// Computes two blows, each with the interval up to the next blow, and returns the waves of both. Times
    /// of the waves are counted from the second blow. If no blow was computed before, only one blow is
    /// computed, and times are counted from it. The waves are null if they are too many, if the computation
    /// fails, or if a stop is requested.
    MarchedWaves takeBlowWithWaves(const std::stop_token& stop);

    /// Changes the waves and the position of the bit slightly, to make a second state near the first one.
    /// Both states are then computed further, which shows how fast they diverge. `distance` is the change of
    /// a wave [F0] and of the position [I0/Zr]. approach() then sets the exact distance of the states.
    void displace(double distance);
    /// Returns the distance between this state and another one of the same problem, both just before a blow.
    /// Its growth from blow to blow gives the Lyapunov exponent. It is the root of a sum of squares of
    /// differences: of waves, lumped masses, and position, velocity and force of the bit. With a machine, its
    /// velocity and the stretch x of its spring are included.
    double distanceTo(const DrillingMarch& other) const;
    /// Moves this state towards the state `other` until distanceTo() returns `distance`. The Lyapunov
    /// exponent is the growth of the distance of two states, which are brought close together again after
    /// every blow.
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
    /// Prescribed force over each time step, from the start of the blow on; empty if a hammer strikes the
    /// string.
    std::vector<WaveCell> m_force;
    std::vector<LossyLine> m_lines;
    /// Joints of neighbouring sections: m_joints[j] is between the sections j and j + 1.
    std::vector<Joint> m_joints;
    RearNode m_rear;
    BitNode m_bit;
    /// Wave losses at the rear end of each section, one for each section. m_downLosses act on waves towards
    /// the rock, m_upLosses on waves away from it.
    std::vector<ReturnedLoss> m_downLosses, m_upLosses;
    /// Whether attenuation in a section or a loss in a joint of the string takes energy from the waves.
    bool m_isWeakened = false;
    /// Waves b that arrive at the rear ends of all sections over one time step.
    std::vector<WaveCell> m_arriving;
    /// Waves that arrive at the rear ends of all sections over one time step, after the losses m_upLosses
    /// have acted on them.
    std::vector<WaveCell> m_returning;
    std::mt19937 m_random;

    long m_count = 0;
    /// Number of whole cells (time steps) from the first blow to the present interval.
    long m_cells = 0;
    /// Number of cells (time steps) in the present interval between two blows.
    long m_nextInterval = 1;
    /// Index, within the present interval, of the cell (time step) in which the computation of the bit
    /// reaches the time of the next blow. The bit is computed ahead of the rear end by the transit time of
    /// the string.
    long m_gapCell = 0;
    std::size_t m_gapPart = 0;  ///< part of cell m_gapCell in which the next blow begins
    double m_gapShare = 0;      ///< fraction of part m_gapPart at which the next blow begins, 0 … 1
    DrillingBlow m_blow, m_next;
    DrillingLedger m_ledger;
    /// Impulse on the rock, in units of I0, that was computed in the present interval and acts before the
    /// next blow. The rest of the interval's impulse acts after that blow, because the bit is computed ahead
    /// of the rear end by the transit time of the string.
    double m_impulseToGap = 0;
    /// Momentum of the string at the last blow, in units of I0, positive towards the rock.
    double m_momentumAtBlow = 0;
    /// Impulse on the rock, in units of I0, that was computed in the interval before the last blow but acts
    /// after that blow. The reason is that the bit is computed ahead of the rear end by the transit time of
    /// the string.
    double m_impulseCarriedOver = 0;
    /// Impulse J that the hammer transferred in the previous interval between blows, in units of I0. It
    /// determines the mean feed force of the next interval.
    double m_lastImpulse = 0;
    double m_startMomentum = 0, m_rockImpulse = 0, m_fed = 0;
    double m_storedBefore = 0;
    /// Energy lost by waves inside the hammers of all blows so far [F0² t0/Zr].
    double m_hammerLost = 0;
    double m_lateShare = 0;
    double m_holeDepth = 0;
    double m_rearPlace = 0;  ///< position x_r of the rear end at the last blow, in units of I0/Zr
    double m_rearMoved = 0;  ///< displacement of the rear end since the last blow, in units of I0/Zr
    double m_stringTransit = 0;
    long m_cell = 0;  ///< index of the present cell within the interval
    std::string_view m_failureReason;
    DrillingSamples* m_samples = nullptr;
    MarchedWaves* m_kept = nullptr;
    /// Number of cells (time steps) from the first blow to the start of the recorded blow, at which the time
    /// of the recorded waves is zero.
    long m_keptCell = 0;
    /// Waves that enter each section over one time step: m_downs at its rear end, m_backs at its front end.
    /// They are needed only while waves are recorded.
    std::vector<WaveCell> m_downs, m_backs;
    /// Position of the bit relative to the bottom of the crater at the next blow, in units of I0/Zr, positive
    /// into the rock.
    double m_nextPlace = 0;
};

}  // namespace drillwave
