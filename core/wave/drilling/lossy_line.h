// SPDX-License-Identifier: GPL-3.0-or-later
// Waves on their way through a section that loses wave energy but no momentum (drilling §3).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/numeric/gauss_rule.h"
#include "core/wave/network/delay_line.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

// Wave read at a fraction of a cell (time step), from a least-squares fit to two stored cells

/// Wave over one cell (time step) that lies across two stored cells. It begins at the fraction θ = `share` of
/// the stored cell `old`, and ends in the following stored cell `next`:
///
///     s(u) = old(u + θ) for u < 1 − θ, next(u − 1 + θ) after,   0 ≤ θ < 1
///
/// The wave is projected to a cubic: ∫s u^k du is conserved for k = 0 … 3, and ∫s² du does not increase.
class CellShift {
  public:
    CellShift() = default;
    /// Creates the projection to cubics for a wave that is shifted by the fraction θ = `share` of a stored
    /// cell (time step), 0 ≤ θ < 1.
    explicit CellShift(double share) : m_share(share) {
        const GaussRule& rule = gaussRule();
        constexpr int count = WaveCell::count;
        for (std::size_t i = 0; i < GaussRule::count; ++i) {
            const auto addTo = [&](auto& map, double from, double to, double offset) {
                const double u = from + (to - from) * rule.nodes[i], weight = (to - from) * rule.weights[i];
                const auto out = basisAt(u), in = basisAt(u + offset);
                for (int k = 0; k < count; ++k)
                    for (int m = 0; m < count; ++m) map[k][m] += weight * (2 * m + 1) * out[m] * in[k];
            };
            addTo(m_ofOld, 0, 1 - share, share);
            addTo(m_ofNext, 1 - share, 1, share - 1);
            const double u = share * rule.nodes[i], weight = share * rule.weights[i];
            const auto head = basisAt(u);
            for (int k = 0; k < count; ++k) {
                m_headMean[k] += weight * head[k];
                for (int m = 0; m < count; ++m) m_headSquare[k][m] += weight * head[k] * head[m];
            }
        }
    }

    /// Returns whether the shift θ is greater than 0. Otherwise each stored cell (time step) is used
    /// directly, without project().
    bool isShifted() const { return m_share > 0; }
    /// Returns the cubic that replaces the wave over a time step (cell) that begins inside the stored cell
    /// `old` and ends inside the following stored cell `next`.
    WaveCell project(const WaveCell& old, const WaveCell& next) const {
        // the coefficients are in separate arrays, so that the processor computes them in parallel
        Row first{}, second{};
        for (int k = 0; k < WaveCell::count; ++k) {
            const double ofOld = old.c[k], ofNext = next.c[k];
            for (int m = 0; m < WaveCell::count; ++m) first[m] += m_ofOld[k][m] * ofOld;
            for (int m = 0; m < WaveCell::count; ++m) second[m] += m_ofNext[k][m] * ofNext;
        }
        WaveCell out;
        for (int m = 0; m < WaveCell::count; ++m) out.c[m] = first[m] + second[m];
        return out;
    }
    /// Returns the integral ∫f du of the wave f over the first fraction θ of its cell (time step), in units
    /// of F0. The cell is the range u = 0 … 1.
    double headMean(const WaveCell& f) const {
        double sum = 0;
        for (int k = 0; k < WaveCell::count; ++k) sum += m_headMean[k] * f.c[k];
        return sum;
    }
    /// Returns the integral ∫f² du of the wave f over the first fraction θ of its cell (time step), in units
    /// of F0². The cell is the range u = 0 … 1.
    double headSquare(const WaveCell& f) const {
        double sum = 0;
        for (int k = 0; k < WaveCell::count; ++k) {
            double row = 0;
            for (int m = 0; m < WaveCell::count; ++m) row += m_headSquare[k][m] * f.c[m];
            sum += row * f.c[k];
        }
        return sum;
    }

  private:
    using Row = std::array<double, WaveCell::count>;
    using Map = std::array<Row, WaveCell::count>;

    /// Returns the Legendre polynomials P_k(2u − 1), k = 0 … 3, at u, 0 ≤ u ≤ 1.
    static Row basisAt(double u) {
        const double x = 2 * u - 1;
        return {1, x, 1.5 * x * x - 0.5, (2.5 * x * x - 1.5) * x};
    }

    double m_share = 0;
    /// Linear maps by which project() computes the Legendre coefficients of its result from those of the
    /// cells `old` and `next`. The first index is the coefficient of the input, the second that of the
    /// result.
    Map m_ofOld{}, m_ofNext{};
    Row m_headMean{};
    Map m_headSquare{};
};

/// Waves in a section of rod or string that lose energy but no momentum. The wave b_in enters the section,
/// the wave b_out leaves it one round trip 2T later. The wave b in the section relaxes to its own mean A at
/// the rate λ = −ln(1 − η)/2T, with the loss η per round trip (D3) (D4):
///
///     B' = b_in − b_out,   A' = λ (B/2T − A),   stored: c = b_in − A,   b_out(t) = (1 − η) c(t − 2T) + A(t)
///
/// −B is the momentum of the section and B/Z its shortening, with B = ∫b dt; the loss changes neither.
///
/// A round trip need not be a whole number of cells (time steps). A leaving wave then consists of parts of
/// two stored cells, and is replaced by its projection to a cubic. The projection conserves B; the energy
/// that it loses is counted in lost().
class LossyLine {
  public:
    /// Prepares the section, and sets the wave in it to 0. Its round trip is `cells` ≥ 1 cells (time steps)
    /// of the size `cell` [t0]. `loss` is the loss η per round trip, 0 ≤ η < 1. `widths` are the widths of
    /// the parts of a cell, in order. `cells` may be fractional only if there is one part.
    void begin(double cells, double cell, double loss, std::span<const double> widths) {
        m_line.restart(static_cast<std::size_t>(std::ceil(cells)) * widths.size(), 1);
        m_shift = CellShift(std::ceil(cells) - cells);
        m_roundTrip = cells * cell;
        const double roundTrip = m_roundTrip;
        m_ofRoundTrip = 1 / roundTrip;
        m_kept = 1 - loss;
        m_rate = loss > 0 ? -std::log1p(-loss) / roundTrip : 0;
        m_parts.clear();
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const double next = widths[i + 1 < widths.size() ? i + 1 : 0];
            const double reached = -std::expm1(-m_rate * next);
            m_parts.push_back({.width = widths[i],
                               .loss = 2 * m_rate * widths[i],
                               .nextKept = std::exp(-m_rate * next),
                               .ofHeld = reached * m_ofRoundTrip,
                               .ofFlux = reached * m_ofRoundTrip * (widths[i] + next / 2)});
        }
        fill(0);
    }
    /// Fills the section with the constant wave `wave`, in units of F0, and sets the energy lost so far to 0.
    void fill(double wave) {
        for (WaveCell& cell : m_line.content()) cell = WaveCell::constant(isLossy() ? 0 : wave);
        m_mean = m_next = wave;
        m_held = wave * m_roundTrip;
        m_square = wave * wave * m_roundTrip;
        m_lost = 0;
        m_oldestSquare = m_line.oldest()->meanSquare();
        m_headAtFilling = 0;
        m_headAtFilling = headEnergy();
    }
    /// Returns whether the section has a wave loss.
    bool isLossy() const { return m_rate > 0; }

    /// Returns the wave b_out that leaves the section over the next time step (a cell or a part of one), in
    /// units of F0.
    WaveCell arrive() {
        WaveCell out = *m_line.oldest();
        if (m_shift.isShifted()) {
            const WaveCell& next = *(m_line.oldest() + 1);
            out = m_shift.project(out, next);
            m_projected = m_kept * m_kept * (m_oldestSquare - out.meanSquare());
            m_oldestSquare = next.meanSquare();
        }
        if (!isLossy()) return out;
        for (double& coefficient : out.c) coefficient *= m_kept;
        out.c[0] += 0.5 * (m_mean + m_next);
        out.c[1] += 0.5 * (m_next - m_mean);
        return out;
    }
    /// Stores the wave b_in that enters the section while the wave `out` leaves it, which arrive() returned
    /// for the same time step. `part` is the index of this time step among the parts of its cell.
    void enter(const WaveCell& in, const WaveCell& out, std::size_t part) {
        WaveCell& stored = *m_line.newest();
        stored = in;
        if (isLossy()) {
            stored.c[0] -= 0.5 * (m_mean + m_next);
            stored.c[1] -= 0.5 * (m_next - m_mean);
        }
        pass(in.mean() - out.mean(), (in - out).meanProduct(in + out), part);
    }
    /// Stores the entering wave b_in = out + change: the leaving wave `out` is reflected with the constant
    /// `change` [F0] added. It replaces enter() for a rod in free flight, for which it is faster.
    void turn(double change, const WaveCell& out, std::size_t part) {
        const WaveCell& oldest = *m_line.oldest();
        WaveCell& stored = *m_line.newest();
        for (int k = 0; k < WaveCell::count; ++k) stored.c[k] = m_kept * oldest.c[k];
        stored.c[0] += change;
        pass(change, change * (2 * out.mean() + change), part);
    }

    /// Returns the integral B = ∫b dt, in units of I0, of the wave b in the section. It is taken over one
    /// round trip 2T, which the wave needs to run through the section and back.
    double held() const { return m_held; }
    /// Returns the integral Q = ∫b² dt, in units of F0² t0, of the square of the wave b in the section. It is
    /// taken over one round trip 2T, which the wave needs to run through the section and back.
    double square() const { return m_square - headEnergy(); }
    /// Returns the energy that the wave b has lost since the last fill(), multiplied by the impedance Z, in
    /// units of F0² t0. It is ∫2λ(Q − B²/2T) dt with the loss rate λ, the transit time T, Q = ∫b² dt and B =
    /// ∫b dt. The numerical loss by the projection of waves to cubics is added.
    double lost() const { return m_lost + headEnergy(); }

    // Functions that compare and move states

    /// Returns the stored cells (time steps) of the wave, the oldest first. They hold the wave less its mean,
    /// c = b − A, or the wave b itself if the section has no loss.
    std::span<const WaveCell> stored() const { return m_line.content(); }
    std::span<WaveCell> stored() { return m_line.content(); }
    /// Returns the mean A to which the wave in the section relaxes, in units of F0; used only with a loss.
    double mean() const { return m_mean; }
    /// Makes the wave in this section similar to that in `other`, the same section in another state of the
    /// computation. Only the fraction `share` (0 … 1) of the difference remains. It changes the stored cells
    /// c, the mean A and the integral B. `widths` are the widths of the parts of a cell (time step), in units
    /// of t0.
    void approach(const LossyLine& other, double share, std::span<const double> widths) {
        const auto others = other.stored();
        const auto own = stored();
        double moved = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            for (int k = 0; k < WaveCell::count; ++k)
                own[i].c[k] = others[i].c[k] + share * (own[i].c[k] - others[i].c[k]);
            // the oldest cell is first
            const double width = widths[i % widths.size()];
            const double age =
                m_roundTrip * (1 - (static_cast<double>(i) + 0.5) / static_cast<double>(own.size()));
            const WaveCell difference = own[i] - others[i];
            const double gone = i == 0 ? m_shift.headMean(difference) : 0;
            moved += width * std::exp(-m_rate * age) * (difference.mean() - gone);
        }
        m_mean = isLossy() ? other.m_mean + share * (m_mean - other.m_mean) : other.m_mean;
        if (isLossy()) moved += m_roundTrip * (m_mean - other.m_mean);
        m_held = other.m_held + moved;
        m_square = other.m_square;
        m_oldestSquare = m_line.oldest()->meanSquare();
        m_next = isLossy() ? other.m_next + share * (m_next - other.m_next) : m_mean;
    }
    /// Adds a constant to the wave in each stored cell (time step), to make a slightly different state for
    /// the Lyapunov exponent. The first constant is `wave` [F0]; each further one is −0.7 times the constant
    /// before.
    void displace(double wave) {
        for (WaveCell& cell : stored()) {
            cell.c[0] += wave;
            wave = -0.7 * wave;  // alternating signs leave the mean almost unchanged
        }
    }

  private:
    DelayLine<WaveCell> m_line;
    CellShift m_shift;          ///< shift by the difference of the stored cells to a round trip
    double m_oldestSquare = 0;  ///< mean square of the wave in the oldest stored cell
    double m_headAtFilling = 0;
    /// Decrease of the mean square [F0²] of the leaving wave in the present time step, caused by its
    /// projection to a cubic. It is a numerical loss of energy.
    double m_projected = 0;
    double m_roundTrip = 1;  ///< round trip 2T of a wave in the section, in units of t0
    double m_ofRoundTrip = 1;
    double m_kept = 1;  ///< factor 1 − η by which a deviation from the mean is reduced
    double m_rate = 0;  ///< rate λ at which the wave relaxes to its mean, per t0
    /// Coefficients for the wave loss (D3) during one time step (a part of a cell).
    struct Part {
        double width;  ///< width Δ of the part, in units of t0
        double loss;   ///< product 2λΔ, relative loss of energy of a deviation
        /// Factor e^(−λΔ) of the present mean A in the equation for the next mean. λ is the rate of
        /// relaxation, Δ the width of the following part of the cell.
        double nextKept;
        /// Factors in the equation for the next mean A of the wave. `ofHeld` multiplies the integral B before
        /// this part, `ofFlux` its rate B' during this part.
        double ofHeld, ofFlux;
    };
    /// Completes one time step: updates the mean A of the wave b, and the integrals B = ∫b dt and Q = ∫b² dt.
    /// `flux` and `power` are the means of the rates B' and Q' over the step; `part` is its index within the
    /// cell. A at the end of the next step is computed in advance, because the leaving wave of that step
    /// depends on it.
    void pass(double flux, double power, std::size_t part) {
        const Part& of = m_parts[part];
        if (isLossy()) {
            m_mean = m_next;
            m_next = of.nextKept * m_mean + of.ofHeld * m_held + of.ofFlux * flux;
        }
        m_held += of.width * flux;
        m_square += of.width * (power - m_projected);
        m_lost += of.width * m_projected;
        if (isLossy()) {
            const double lost = of.loss * (m_square - m_held * m_held * m_ofRoundTrip);
            m_square -= lost;
            m_lost += lost;
        }
        m_line.advance(1);
    }

    /// Returns ∫b² dt of that part of the oldest stored cell (time step) which has already left the section.
    /// It is subtracted from m_square, which includes the whole cell.
    double headEnergy() const {
        if (!m_shift.isShifted()) return 0;
        const double head = m_shift.headSquare(*m_line.oldest());
        return m_kept * m_kept * m_parts.front().width * head - m_headAtFilling;
    }

    std::vector<Part> m_parts;
    double m_mean = 0, m_next = 0;    ///< mean A of the wave before and after the next part
    double m_held = 0, m_square = 0;  ///< integrals B and Q of the wave and of its square
    double m_lost = 0;
};

}  // namespace drillwave
