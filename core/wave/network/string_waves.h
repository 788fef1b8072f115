// SPDX-License-Identifier: GPL-3.0-or-later
// Waves in hammer and string over time, for any position (strings §2).
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "core/numeric/piecewise.h"
#include "core/wave/impact.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Side of a time at which a wave jumps: the value just before it, or just after it.
enum class TimeSide { before, after };

/// Wave in a uniform piece of hammer or string, as seen at one position of the piece.
struct WaveAtPlace {
    /// Wave at the end where it enters the piece: one cubic polynomial for each time step.
    const std::vector<WaveCell>* cells;
    /// Value of the wave before its first recorded time step arrives, in units of F0.
    double first;
    /// Time t/t0 at which the clock of the uniform piece's rear end reads zero.
    double rearTime;
    /// Delay from rearTime until the wave that entered at the clock reading zero arrives at this position, in
    /// units of t0: ξτ for the wave f towards the rock, (2 − ξ)τ for the wave b away from it.
    double delay;
    /// Factor by which attenuation has reduced the wave's amplitude at this position; 0 … 1.
    double kept;

    /// Returns the time t/t0 at which the wave that entered the piece at the clock reading zero arrives at
    /// this position.
    double zero() const { return rearTime + delay; }
};

/// Both waves of one uniform piece of hammer or string, where they enter the piece. The wave f towards the
/// rock enters at the rear end, the wave b away from it at the front end. Each end has its own clock, given
/// by `rearTime`.
struct SectionWaves {
    /// Impedance of the uniform piece, ζ = Z/Zr with the reference impedance Zr.
    double impedance = 1;
    /// One-way transit time τ of this uniform piece of hammer or string, in units of t0.
    double transitTime = 1;
    /// Attenuation αL of a wave over one transit of the uniform piece; ≥ 0.
    double decay = 0;
    /// Time t/t0 at which the clock of the rear end reads zero; the clock of the front end reads zero τ
    /// later.
    double rearTime = 0;
    /// Value of the wave f towards the rock before `rearTime`, in units of F0. The wave b away from the rock
    /// has the value −first then.
    double first = 0;
    /// Waves f towards the rock (`down`) and b away from it (`up`) where they enter the piece, one cubic for
    /// each time step.
    std::vector<WaveCell> down, up;

    /// Returns the wave f towards the rock as seen at the position ξ in the piece, 0 at its rear end … 1.
    WaveAtPlace downAt(double xi) const;
    /// Returns the wave b away from the rock as seen at the position ξ in the piece, 0 at its rear end … 1.
    WaveAtPlace upAt(double xi) const;
};

/// Waves and motion of hammer and string over time. Units are those of Problem; times start with the first
/// contact of hammer and string. A position is given by the number of a section of the scenario, and by ξ, 0
/// at its rear end and 1 at its front end. Compression and motion towards the rock are positive. A section
/// consists of one or several uniform pieces, and in each of them:
///
///     P(ξ, t) = f(t − ξτ) e^(−ξαL) + b(t − (1 − ξ)τ) e^(−(1 − ξ)αL),   v = (f − b)/ζ
///
/// Over each cell (time step) a wave is a cubic. Its integrals are those of the computation. Its values have
/// an error of 1e-9 if cells were divided at every bend of a wave. A time within rounding of a jump is taken
/// as that of the jump.
class StringWaves {
  public:
    /// Approximate limit of the memory for waves, in bytes.
    static constexpr std::size_t mostBytes = 40'000'000;

    /// Creates an empty recording. `rearTimes` are the times t/t0 at which the clocks of the rear ends of the
    /// uniform pieces read zero.
    StringWaves(const Problem& problem, const std::vector<double>& rearTimes);

    // Functions for recording

    /// Adds one time step of the two waves of a uniform piece: `down` towards the rock, `up` away from it,
    /// each where it enters the piece. Compression is positive, in units of F0.
    void add(std::size_t piece, const WaveCell& down, const WaveCell& up) {
        m_pieces[piece].down.push_back(down);
        m_pieces[piece].up.push_back(up);
    }
    /// Adds a time step that starts at the clock reading `clock` and has the given width, both in t0.
    /// `bitForce` is the impact force over it. `rearForce` is the force on the rear end of the first section;
    /// it is ignored if a hammer strikes the string. Negative clock readings are before the blow.
    void addStep(double clock, double width, const WaveCell& bitForce, const WaveCell& rearForce);
    /// Adds a second force on the rear end of the string, that of a damper, over the time step that addStep()
    /// added last. It must be added for all steps or for none.
    void addDamper(const WaveCell& force) { m_damperForces.push_back(force); }
    /// Sets the momentum of rod or string at the start of the blow, in units of I0.
    void setMomentum(double momentum) { m_momentum = momentum; }
    /// Returns whether the memory limit mostBytes is reached, so that no more steps should be added.
    bool isFull() const;
    /// Ends the recording; all waves are known up to the time `end`, in units of t0.
    void finish(double end);

    // Functions for reading

    /// Returns the time t/t0 up to which the waves are known at all positions.
    double end() const { return m_end; }
    /// Returns the waves f and b of every uniform piece, from the rear end of the hammer to the bit.
    std::span<const SectionWaves> pieces() const { return m_pieces; }
    /// Returns the number of sections of the scenario, in hammer and string together.
    std::size_t sections() const { return m_firstPieces.size() - 1; }
    /// Returns the number of sections of the scenario that belong to the hammer; 0 for a prescribed force.
    std::size_t hammerSections() const;
    /// Returns the index in pieces() of the first piece of a section. For section == sections() it returns
    /// the number of pieces.
    std::size_t firstPiece(std::size_t section) const { return m_firstPieces[section]; }
    /// Returns the number of uniform pieces that replace a section; ≥ 1.
    int piecesOf(std::size_t section) const {
        return static_cast<int>(m_firstPieces[section + 1] - m_firstPieces[section]);
    }
    /// Position in a uniform piece: the index of the piece in pieces(), and ξ in it, 0 at its rear end … 1.
    struct PiecePlace {
        std::size_t piece;
        double xi;
    };
    /// Returns the uniform piece at the position ξ of a section, and the position in it. Where two pieces
    /// meet, the one towards the rock is taken.
    PiecePlace pieceAt(std::size_t section, double xi) const;
    /// Returns the clock reading at the start of each recorded time step, in units of t0. Each end of a piece
    /// has its own clock; the readings are the same for all waves.
    std::span<const double> clocks() const { return m_clocks; }
    /// Returns the width of each recorded time step, in units of t0. It is the same for all waves.
    std::span<const double> widths() const { return m_widths; }
    /// Returns the force P/F0 at the time t [t0] at the position ξ of a section (0 rear end … 1 front end),
    /// compression positive.
    double force(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const {
        return down(section, xi, t, side) + up(section, xi, t, side);
    }
    /// Returns the particle velocity at the time t [t0] at the position ξ of a section (0 rear end … 1 front
    /// end). The unit is F0/Zr; motion towards the rock is positive.
    double velocity(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const {
        return (down(section, xi, t, side) - up(section, xi, t, side)) /
               m_pieces[pieceAt(section, xi).piece].impedance;
    }
    /// Returns the wave towards the rock at the time t [t0] at the position ξ of a section (0 rear end … 1
    /// front end). The unit is F0; compression is positive.
    double down(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const;
    /// Returns the wave away from the rock at the time t [t0] at the position ξ of a section (0 rear end … 1
    /// front end). The unit is F0; compression is positive.
    double up(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const;
    /// Returns the impulse of the wave towards the rock at the position ξ of a section (0 rear end … 1 front
    /// end), in units of I0. It is the integral of the wave from the first contact of hammer and string to
    /// the time t.
    double downImpulse(std::size_t section, double xi, double t) const;
    /// Returns the impulse of the wave away from the rock at the position ξ of a section (0 rear end … 1
    /// front end), in units of I0. It is the integral of the wave from the first contact of hammer and string
    /// to the time t.
    double upImpulse(std::size_t section, double xi, double t) const;

    /// Returns the momentum that rod or string would have at the time t if there were no rock, in units of
    /// I0.
    double given(double t) const { return m_momentum + m_faceForce.integral(t) + m_damperForce.integral(t); }

    /// Returns times from 0 to end() in increasing order, in units of t0. Between neighbouring times, both
    /// waves at the position ξ of the section are smooth. Times that differ only by rounding are merged.
    std::vector<double> pieceTimes(std::size_t section, double xi) const;

    // Curves over the time t/t0 from 0 on; the three curves at the bit have the same pieces

    /// Returns the force between hammer and string, or the prescribed force, in units of F0; compression
    /// positive.
    const PiecewisePolynomial& faceForce() const { return m_faceForce; }
    /// Returns the damper force on the rear end of the string, in units of F0; empty if there is none.
    const PiecewisePolynomial& damperForce() const { return m_damperForce; }
    /// Returns the impact force F/F0 of bit and rock; ≥ 0.
    const PiecewisePolynomial& bitForce() const { return m_bitForce; }
    /// Returns the wave g/F0 that arrives at the bit, compression positive.
    const PiecewisePolynomial& bitWave() const { return m_bitWave; }
    /// Returns the velocity of the bit towards the rock, in units of F0/Zr; with a bit mass, that of the
    /// mass. Its integral is the displacement of the bit.
    const PiecewisePolynomial& bitVelocity() const { return m_bitVelocity; }

    /// Returns the largest difference of two times that counts as rounding, in units of t0; ≥ 0.
    double rounding() const;

  private:
    WaveAtPlace downAt(std::size_t section, double xi) const;
    WaveAtPlace upAt(std::size_t section, double xi) const;
    std::size_t stepAt(double clock) const;
    double value(const WaveAtPlace& wave, double t, TimeSide side) const;
    double impulse(const WaveAtPlace& wave, double t) const;
    double begin() const { return m_clocks.empty() ? 0 : m_clocks.front(); }
    void makeCurves();

    std::vector<SectionWaves> m_pieces;
    /// Index of the first uniform piece of each section of the scenario; the last entry is the number of
    /// pieces.
    std::vector<std::size_t> m_firstPieces;
    std::size_t m_hammerPieces;
    /// Clock reading at the start of each time step, and width of each time step, in units of t0.
    std::vector<double> m_clocks, m_widths;
    /// Impact force, force on the rear end of the string, and damper force over each time step, in units of
    /// F0. finish() converts them to curves. The second is empty if a hammer strikes the string, the third if
    /// there is no damper.
    std::vector<WaveCell> m_bitForces, m_rearForces, m_damperForces;
    double m_end = 0;
    double m_momentum = 0;
    PiecewisePolynomial m_faceForce, m_damperForce, m_bitForce, m_bitWave, m_bitVelocity;
};

// Largest forces at every position of hammer and string (strings §7)

/// Returns the largest compression and tension at the position ξ of a section (0 rear end … 1 front end),
/// with their times. They are given for the blow, up to `endOfBlow`, and for the residual waves from then up
/// to `until` (all in units of t0). The result is exact for the recorded cubics. At a jump of a wave, the
/// values on both sides count; if both waves jump at once, all four combinations count.
SectionForces largestForcesAt(const StringWaves& waves, std::size_t section, double xi, double endOfBlow,
                              double until = std::numeric_limits<double>::infinity());

/// Largest forces at positions along one section, in order from its rear end to its front end, both ends
/// included.
using SectionEnvelope = std::vector<SectionForces>;

/// Number of positions along hammer and string for which stringEnvelope() computes the largest forces, and
/// limit of its work.
struct EnvelopeGrid {
    /// Approximate number of positions in hammer and string, distributed in proportion to transit time.
    int places = 400;
    /// Minimum number of intervals between positions in each section.
    int leastOfSection = 8;
    /// Maximum number of cells (time steps of waves) to examine; if more are needed, the number of positions
    /// is reduced.
    long mostSteps = 20'000'000;
};

/// Returns the largest forces along every section, from the rear end of the hammer on. Requires recorded
/// waves (impact.waves). If the largest forces of the sections are known (impact.sections), their positions
/// are included. In a section of one uniform piece, no returned force exceeds them, because recorded waves
/// may be less accurate. A stop request ends the work early; the remaining sections then have no positions.
std::vector<SectionEnvelope> stringEnvelope(const Impact& impact, const std::stop_token& stop = {},
                                            const EnvelopeGrid& grid = {});

}  // namespace drillwave
