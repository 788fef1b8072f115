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

/// Side of a jump: the value until then, or from then on.
enum class TimeSide { before, after };

/// Wave of a piece as it passes a place.
struct WaveAtPlace {
    const std::vector<WaveCell>* cells;  ///< as they enter, one per step of the clock
    double first;                        ///< value before the first of them arrives
    double rearTime;                     ///< global time of that zero at the position of the clock
    double delay;                        ///< from there to here
    double kept;                         ///< share of a cell that is left here

    double zero() const { return rearTime + delay; }  ///< when its clock is at 0 here
};

/// Both waves of one uniform piece, each cell as it enters: f at the rear end, b at the front end, where a
/// clock starts from 0.
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

/// Motions of hammer and string at any time. Units of Problem, times global, from the first touch; sections
/// of the chain, whatever pieces stand for them, ξ = 0 at the rear end of a section and 1 at its front end.
/// Compression and motion towards the rock are positive, in every piece:
///
///     P(ξ, t) = f(t − ξτ) e^(−ξαL) + b(t − (1 − ξ)τ) e^(−(1 − ξ)αL),   v = (f − b)/ζ
///
/// Accurate to a cubic over a cell: sums are those of the run, values are accurate to some 1e-9 in a sure
/// one. A time within rounding of a jump is taken as that of the jump.
class StringWaves {
  public:
    /// Approximate limit of the memory for waves.
    static constexpr std::size_t mostBytes = 40'000'000;

    StringWaves(const Problem& problem, const std::vector<double>& rearTimes);

    // During recording

    /// Adds the next cells of the two waves of a piece, as they enter it.
    void add(std::size_t piece, const WaveCell& down, const WaveCell& up) {
        m_pieces[piece].down.push_back(down);
        m_pieces[piece].up.push_back(up);
    }
    /// Adds a step; `rearForce` is the force on the rear end of the first section if it replaces a hammer.
    /// Clocks below 0 describe the time before the blow.
    void addStep(double clock, double width, const WaveCell& bitForce, const WaveCell& rearForce);
    /// Adds another force on the rear end of the string over the last step added; for all steps or none.
    void addDamper(const WaveCell& force) { m_damperForces.push_back(force); }
    /// Sets the momentum of rod or string when the blow begins [I0].
    void setMomentum(double momentum) { m_momentum = momentum; }
    bool isFull() const;
    /// Ends the recording; everything is known up to `end`.
    void finish(double end);

    // For reading

    double end() const { return m_end; }  ///< all places are known until then
    std::span<const SectionWaves> pieces() const { return m_pieces; }
    /// Return the numbers of sections of the chain, and of those of the hammer.
    std::size_t sections() const { return m_firstPieces.size() - 1; }
    std::size_t hammerSections() const;
    /// Returns the first of pieces() of a section; after the last section, their number.
    std::size_t firstPiece(std::size_t section) const { return m_firstPieces[section]; }
    int piecesOf(std::size_t section) const {
        return static_cast<int>(m_firstPieces[section + 1] - m_firstPieces[section]);
    }
    /// Place in a piece.
    struct PiecePlace {
        std::size_t piece;
        double xi;
    };
    /// Returns the piece at a place of a section; where two meet, the one after it.
    PiecePlace pieceAt(std::size_t section, double xi) const;
    /// Return the clock at which each cell of all waves begins, and its width.
    std::span<const double> clocks() const { return m_clocks; }
    std::span<const double> widths() const { return m_widths; }
    double force(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const {
        return down(section, xi, t, side) + up(section, xi, t, side);
    }
    double velocity(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const {
        return (down(section, xi, t, side) - up(section, xi, t, side)) /
               m_pieces[pieceAt(section, xi).piece].impedance;
    }
    /// Return the waves that run to the rock and back, at a place.
    double down(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const;
    double up(std::size_t section, double xi, double t, TimeSide side = TimeSide::after) const;
    /// Return the integral of these from the first touch on.
    double downImpulse(std::size_t section, double xi, double t) const;
    double upImpulse(std::size_t section, double xi, double t) const;

    /// Returns the momentum that rod or string would have until then without the rock [I0].
    double given(double t) const { return m_momentum + m_faceForce.integral(t) + m_damperForce.integral(t); }

    /// Returns the times from 0 to end() between which all waves at a place are smooth, in order; two that
    /// differ by rounding are one.
    std::vector<double> pieceTimes(std::size_t section, double xi) const;

    // Over global time from 0 on; those at the bit are on the same pieces.

    const PiecewisePolynomial& faceForce() const {
        return m_faceForce;
    }  ///< of hammer, or given force, and string
    const PiecewisePolynomial& damperForce() const { return m_damperForce; }  ///< empty without
    const PiecewisePolynomial& bitForce() const { return m_bitForce; }        ///< F of the rock
    const PiecewisePolynomial& bitWave() const { return m_bitWave; }          ///< g that arrives at the bit
    /// Returns U' of the bit, with its mass if it has one; the integral is its displacement.
    const PiecewisePolynomial& bitVelocity() const { return m_bitVelocity; }

    /// Returns the difference up to which two times are the same.
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

/// Largest forces of one section at places in order, its ends included.
using SectionEnvelope = std::vector<SectionForces>;

/// Fineness and work limit of an envelope.
struct EnvelopeGrid {
    int places = 400;             ///< in hammer and string, about, shared out by transit time
    int leastOfSection = 8;       ///< of a short one
    long mostSteps = 20'000'000;  ///< cells to be looked at; with more work there are fewer places
};

/// Returns the envelope of every section, the rear of the hammer first. Where the largest forces of a section
/// are known (impact.sections), their places are among those of the envelope, and nothing is larger in a
/// section that is one uniform piece: the waves that were kept may be less exact. Requires kept waves. A stop
/// ends the work early: the remaining sections have no places.
std::vector<SectionEnvelope> stringEnvelope(const Impact& impact, const std::stop_token& stop = {},
                                            const EnvelopeGrid& grid = {});

}  // namespace drillwave
