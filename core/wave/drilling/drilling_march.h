// SPDX-License-Identifier: GPL-3.0-or-later
// Blow after blow on cells: waves, motions and machine live on between them (drilling §6).
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

// Loss that transfers no momentum to the surroundings: what a joint or the attenuation takes from a wave
// returns over the time between two blows (drilling §3).

/// A place and direction, for waves x of a section with impedance Z:
///
///     out = s x + (1 − s) m,   m' = f (x − m)                                                       (D5)
///
/// Steady waves pass unchanged. (1 − s) m/f is momentum on its way, (1 − s) m²/(f Z) its energy.
class ReturnedLoss {
  public:
    ReturnedLoss() = default;
    /// s of an amplitude, 0 < s ≤ 1; f blows per t0.
    ReturnedLoss(double passing, double frequency) : m_passing(passing), m_frequency(frequency) {}

    /// Returns the wave that passes over a part of a cell of that width [t0]. The trapezoidal rule for m
    /// keeps the momentum exactly.
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

    double mean() const { return m_mean; }  ///< m
    void setMean(double mean) { m_mean = mean; }
    double held() const { return (1 - m_passing) * m_mean / m_frequency; }  ///< momentum on its way back
    double square() const { return held() * m_mean; }                       ///< its energy times Z
    double lost() const { return m_lost; }                                  ///< times Z, since the beginning

  private:
    double m_passing = 1, m_frequency = 1;
    double m_mean = 0;
    double m_lost = 0;
};

/// State of the rear end at the end of a part of a cell.
struct RearSample {
    double time = 0;  ///< since the first blow
    double velocity = 0;
    double damperForce = 0;
    double bodyPlace = 0;  ///< x_b; that of the rear end under a constant force
};

/// State of the bit; its clock is one transit time late, which is corrected here.
struct BitSample {
    double time = 0;
    double force = 0;
    double penetration = 0;  ///< from the face of the rock before the first blow
    double velocity = 0;
};

struct DrillingSamples {
    std::vector<RearSample> rear;
    std::vector<BitSample> bit;
};

/// The waves of one blow of a march and of the cycle before it, in which they began; times since that blow.
struct MarchedWaves {
    std::shared_ptr<StringWaves> waves;  ///< nothing where they are more than can be kept
    std::vector<ImpactEvent> events;     ///< including those of the cycle before
    double place = 0;                    ///< of the bit from the bottom of the crater, negative while apart
    double rememberedForce = 0;          ///< largest that the rock of the blow has felt before
    double residual = 0;                 ///< penetration that stays of blows before
    double hammerWork = 0;               ///< of the force, or transferred by the piston
    double rockWork = 0;                 ///< ∫F dU, less the work lost with replaced rock
    double transitTime = 0;              ///< from the rear end to the bit, in whole cells
};

/// Takes one blow after another in the same memory: memory and work of a blow do not depend on their number.
/// Every node has its own clock, as in CellLattice: that of the bit is later than that of the rear end by the
/// transit time of the string.
class DrillingMarch {
  public:
    /// The problem must outlive it.
    DrillingMarch(const DrillingProblem& problem, const DrillingGrid& grid);

    /// Follows one blow and the cycle after it. False after a stop, or if it cannot go on: see
    /// failureReason().
    bool takeBlow(const std::stop_token& stop);
    /// Returns the last blow.
    const DrillingBlow& blow() const { return m_blow; }
    long blows() const { return m_count; }
    /// Returns the energies of all cycles so far.
    const DrillingLedger& ledger() const { return m_ledger; }
    /// Returns Σ rock impulse − N Fe/f + p_end − p_start [I0], which is rounding.
    double momentumResidual() const;
    /// Returns the impulse of the face after its first separation, in the last cycle, as a share of m_h v0.
    double lateShare() const { return m_lateShare; }
    /// Returns the work of all blows so far [cells × nodes], including events at the bit.
    double work() const;
    /// Returns why it could not go on; empty if it could.
    std::string_view failureReason() const { return m_failureReason; }
    /// Returns m_h v0; 1 under a prescribed force.
    double hammerMomentum() const { return m_hammerMomentum; }

    /// Records the following blows in `samples`; nullptr: none.
    void watch(DrillingSamples* samples) { m_samples = samples; }
    /// Follows a cycle and the blow after it, keeping the waves of both; the first blow has no cycle before
    /// it. Has no waves if the march stopped or cannot go on, or if they are too many.
    MarchedWaves takeBlowWithWaves(const std::stop_token& stop);

    /// Moves waves and bit a little, so that approach() can reduce the distance.
    void displace(double distance);
    /// Returns the distance between this state and another one of the same problem, between blows: of waves,
    /// place of the bit, v_b, and x with a spring.
    double distanceTo(const DrillingMarch& other) const;
    /// Moves the state towards the other one until this distance remains.
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
    std::size_t m_hammer = 0;  ///< sections of it
    double m_interval = 1;     ///< mean [t0]
    double m_stringMass = 0, m_hammerMomentum = 1, m_hammerMass = 0;
    std::vector<WaveCell> m_force;  ///< Fa over the parts of cells from its front on
    std::vector<LossyLine> m_lines;
    std::vector<Joint> m_joints;  ///< in front of section j + 1 at [j]
    RearNode m_rear;
    BitNode m_bit;
    std::vector<ReturnedLoss> m_downLosses, m_upLosses;  ///< at the rear end of each section
    bool m_isWeakened = false;                           ///< one of them takes something
    std::vector<WaveCell> m_arriving;                    ///< b of all lines over a part
    std::vector<WaveCell> m_returning;                   ///< the same after m_upLosses
    std::mt19937 m_random;

    long m_count = 0;
    long m_cells = 0;           ///< whole cells since the first blow
    long m_nextInterval = 1;    ///< cells of the cycle
    long m_gapCell = 0;         ///< cell from the blow in which the next one arrives
    std::size_t m_gapPart = 0;  ///< of it
    double m_gapShare = 0;      ///< of that part
    DrillingBlow m_blow, m_next;
    DrillingLedger m_ledger;
    double m_impulseToGap = 0;        ///< of the rock, in the cycle, until the next blow at the rear end
    double m_momentumAtBlow = 0;      ///< of the string, at the physical time of the blow
    double m_impulseCarriedOver = 0;  ///< impulse of the rock after that time, in the cycle before
    double m_lastImpulse = 0;         ///< J of the cycle before
    double m_startMomentum = 0, m_rockImpulse = 0, m_fed = 0;
    double m_storedBefore = 0;
    double m_hammerLost = 0;  ///< by the waves of all pistons
    double m_lateShare = 0;
    double m_holeDepth = 0;
    double m_rearPlace = 0;  ///< x_r, at the blow
    double m_rearMoved = 0;  ///< since then
    double m_stringTransit = 0;
    long m_cell = 0;  ///< of the cycle
    std::string_view m_failureReason;
    DrillingSamples* m_samples = nullptr;
    MarchedWaves* m_kept = nullptr;
    long m_keptCell = 0;                     ///< since the first blow: where their clock is at 0
    std::vector<WaveCell> m_downs, m_backs;  ///< that enter each section over a part
    double m_nextPlace = 0;                  ///< of the bit at the next blow, from the bottom of the crater
};

}  // namespace drillwave
