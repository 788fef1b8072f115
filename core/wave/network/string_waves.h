// SPDX-License-Identifier: GPL-3.0-or-later
// The waves in hammer and string while a blow lasts, to be read at any place and time (strings §2).
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

/// Where something jumps: what was until then, or what is from then on.
enum class TimeSide { before, after };

/// One of the waves of a piece as it passes a place.
struct WaveAtPlace {
    const std::vector<WaveCell>* cells;  ///< as they enter, one a step of the clock
    double first;                        ///< what it is before the first of them gets here
    double rearTime;                     ///< global time of that zero where the clock is
    double delay;                        ///< from there to here
    double kept;                         ///< what is left of the cells on the way

    double zero() const { return rearTime + delay; }  ///< when its clock is at 0 here
};

/// Both waves of one uniform piece, each cell as it enters: f at the rear end, b at the front end, where a
/// clock counts from 0.
struct SectionWaves {
    double impedance = 1;    ///< ζ
    double transitTime = 1;  ///< τ
    double decay = 0;        ///< αL
    double rearTime = 0;     ///< global time of the clock's zero at the rear end; at the front end τ later
    double first = 0;        ///< f before that, and −b
    std::vector<WaveCell> down, up;

    WaveAtPlace downAt(double xi) const;
    WaveAtPlace upAt(double xi) const;
};

/// Looks up what hammer and string do. Units of Problem, times global, from the first touch; sections of the
/// chain, whatever pieces stand for them, ξ = 0 at the rear end of a section and 1 at its front end.
/// Compression and motion towards the rock are positive, in every piece:
///
///     P(ξ, t) = f(t − ξτ) e^(−ξαL) + b(t − (1 − ξ)τ) e^(−(1 − ξ)αL),   v = (f − b)/ζ
///
/// Accurate to what a cubic over a cell is: sums are those of the run, values to some 1e-9 where that is a
/// sure one. A time that is but for rounding that of a jump is taken for it.
class StringWaves {
  public:
    /// What is kept is at most about so many bytes.
    static constexpr std::size_t mostBytes = 40'000'000;

    StringWaves(const Problem& problem, const std::vector<double>& rearTimes);

    // While it is recorded

    /// What the clocks go through next, after the waves that enter then in every piece.
    void add(std::size_t piece, const WaveCell& down, const WaveCell& up) {
        m_pieces[piece].down.push_back(down);
        m_pieces[piece].up.push_back(up);
    }
    /// `rearForce` is that on the rear end of the first section where it is given in place of a hammer.
    /// Clocks that begin below 0 tell what was before the blow.
    void addStep(double clock, double width, const WaveCell& bitForce, const WaveCell& rearForce);
    /// What else pushes the rear end of the string over the step that was added last; of all steps or none.
    void addDamper(const WaveCell& force) { m_damperForces.push_back(force); }
    /// What rod or string has when the blow begins [I0].
    void setMomentum(double momentum) { m_momentum = momentum; }
    bool isFull() const;
    /// Nothing follows; what is told is told up to `end`.
    void finish(double end);

    // To be read

    double end() const { return m_end; }  ///< all places are known until then
    std::span<const SectionWaves> pieces() const { return m_pieces; }
    /// Sections of the chain, of which so many are the hammer's.
    std::size_t sections() const { return m_firstPieces.size() - 1; }
    std::size_t hammerSections() const;
    /// The first of pieces() of a section; behind the last section all of them.
    std::size_t firstPiece(std::size_t section) const { return m_firstPieces[section]; }
    int piecesOf(std::size_t section) const {
        return static_cast<int>(m_firstPieces[section + 1] - m_firstPieces[section]);
    }
    /// A place in a piece.
    struct PiecePlace {
        std::size_t piece;
        double xi;
    };
    /// That of a section, in the piece behind it where two meet.
    PiecePlace pieceAt(std::size_t section, double xi) const;
    /// Of the cells of all waves: where on the clocks each begins, and how long it is.
    std::span<const double> clocks() const { return m_clocks; }
    std::span<const double> widths() const { return m_widths; }
    double force(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const {
        return down(section, xi, t, side) + up(section, xi, t, side);
    }
    double velocity(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const {
        return (down(section, xi, t, side) - up(section, xi, t, side)) /
               m_pieces[pieceAt(section, xi).piece].impedance;
    }
    /// The wave that runs to the rock, and the one that comes back, where they are.
    double down(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const;
    double up(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const;
    /// ∫ of these from the first touch on.
    double downImpulse(std::size_t section, double xi, double t) const;
    double upImpulse(std::size_t section, double xi, double t) const;

    /// The momentum that rod or string would have until then without the rock [I0].
    double given(double t) const { return m_momentum + m_faceForce.integral(t) + m_damperForce.integral(t); }

    /// Times from 0 to end() between which all waves at a place are smooth, in order; two that differ by
    /// rounding are one.
    std::vector<double> pieceTimes(std::size_t section, double xi) const;

    // Over global time from 0 on; those at the bit are on the same pieces.

    const PiecewisePolynomial& faceForce() const {
        return m_faceForce;
    }  ///< of hammer, or given force, and string
    const PiecewisePolynomial& damperForce() const { return m_damperForce; }  ///< empty without
    const PiecewisePolynomial& bitForce() const { return m_bitForce; }        ///< F of the rock
    const PiecewisePolynomial& bitWave() const { return m_bitWave; }          ///< g that arrives at the bit
    /// U' of the bit, with its mass where it has one: its integral is how far it has moved.
    const PiecewisePolynomial& bitVelocity() const { return m_bitVelocity; }

    /// What two times may differ by and be the same.
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
    std::vector<std::size_t> m_firstPieces;  ///< of each section, and how many there are
    std::size_t m_hammerPieces;
    std::vector<double> m_clocks, m_widths;  ///< of the steps
    std::vector<WaveCell> m_bitForces, m_rearForces,
        m_damperForces;  ///< until finish(), those that are wanted
    double m_end = 0;
    double m_momentum = 0;
    PiecewisePolynomial m_faceForce, m_damperForce, m_bitForce, m_bitWave, m_bitVelocity;
};

// The largest forces at every place of hammer and string while a blow lasts (strings §7).

/// The largest compression and tension at the place ξ of a section until the blow is over, and from there to
/// `until`, and when; all have that place. One merge of the two waves that pass there, exact for their
/// cubics; at a jump both sides count, and where two meet all four.
SectionForces largestForcesAt(const StringWaves& waves, std::size_t section, double xi, double endOfBlow,
                              double until = std::numeric_limits<double>::infinity());

/// Those of one section at places in order, its ends among them.
using SectionEnvelope = std::vector<SectionForces>;

/// How fine an envelope is, and what it may cost.
struct EnvelopeGrid {
    int places = 400;             ///< in hammer and string, about, shared out by transit time
    int leastOfSection = 8;       ///< of a short one
    long mostSteps = 20'000'000;  ///< cells to be looked at; with more there are fewer places
};

/// Of every section, the rear of the hammer first. Where the largest forces of a section are known
/// (impact.sections), their places are among those of the envelope, and nothing is larger in a section that
/// is one uniform piece: the waves that were kept may be less exact. Requires waves that were kept. A stop
/// ends the work early: the sections that are left have no places.
std::vector<SectionEnvelope> stringEnvelope(const Impact& impact, const std::stop_token& stop = {},
                                            const EnvelopeGrid& grid = {});

}  // namespace drillwave
