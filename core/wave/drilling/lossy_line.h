// SPDX-License-Identifier: GPL-3.0-or-later
// The waves on their way back through a section that loses some of them and keeps its momentum (drilling §3).
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

// A wave read at an offset of a fraction of a cell: the least-squares projection of two stored cells.

/// Two consecutive cells, seen from `share` of the first one on over the width of a cell:
///
///     s(u) = old(u + θ) for u < 1 − θ, next(u − 1 + θ) after,   0 ≤ θ < 1
///
/// projected on the cubics: ∫s u^k du is kept for k = 0 … 3, and ∫s² du does not grow.
class CellShift {
  public:
    CellShift() = default;
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

    bool isShifted() const { return m_share > 0; }
    WaveCell project(const WaveCell& old, const WaveCell& next) const {
        // in arrays of their own the coefficients are worked on side by side
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
    /// ∫f du over the first `share` of a cell.
    double headMean(const WaveCell& f) const {
        double sum = 0;
        for (int k = 0; k < WaveCell::count; ++k) sum += m_headMean[k] * f.c[k];
        return sum;
    }
    /// ∫f² du over the first `share` of a cell.
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

    /// P_k(2u − 1).
    static Row basisAt(double u) {
        const double x = 2 * u - 1;
        return {1, x, 1.5 * x * x - 0.5, (2.5 * x * x - 1.5) * x};
    }

    double m_share = 0;
    Map m_ofOld{}, m_ofNext{};  ///< [of input][of output]
    Row m_headMean{};
    Map m_headSquare{};
};

/// Content b over one round trip 2T that relaxes to its own mean at the rate λ = −ln(1 − η)/2T (D3) (D4):
///
///     B' = b_in − b_out,   A' = λ (B/2T − A),   stored: c = b_in − A,   b_out(t) = (1 − η) c(t − 2T) + A(t)
///
/// −B is the momentum of the section, B/Z its shortening: neither is changed by the loss.
///
/// A round trip need not be whole cells: then the wave that arrives over a cell lies in two stored ones, and
/// is their projection. That keeps B, and its loss of energy is counted.
class LossyLine {
  public:
    /// A round trip of `cells` ≥ 1 of size `cell` [t0]; not whole ones only where cells have one part. The
    /// widths of the parts of a cell follow each other in turn.
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
    /// Fills the line with a constant wave.
    void fill(double wave) {
        for (WaveCell& cell : m_line.content()) cell = WaveCell::constant(isLossy() ? 0 : wave);
        m_mean = m_next = wave;
        m_held = wave * m_roundTrip;
        m_square = wave * wave * m_roundTrip;
        m_lost = 0;
        m_oldestSquare = m_line.arriving()->meanSquare();
        m_headAtFilling = 0;
        m_headAtFilling = headEnergy();
    }
    bool isLossy() const { return m_rate > 0; }

    /// b_out over the next part of a cell.
    WaveCell arrive() {
        WaveCell out = *m_line.arriving();
        if (m_shift.isShifted()) {
            const WaveCell& next = *(m_line.arriving() + 1);
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
    /// b_in over that part, the `part`-th of its cell, in which `out` has arrived.
    void enter(const WaveCell& in, const WaveCell& out, std::size_t part) {
        WaveCell& stored = *m_line.leaving();
        stored = in;
        if (isLossy()) {
            stored.c[0] -= 0.5 * (m_mean + m_next);
            stored.c[1] -= 0.5 * (m_next - m_mean);
        }
        pass(in.mean() - out.mean(), (in - out).meanProduct(in + out), part);
    }
    /// Takes b_in as the arriving wave plus a constant `change`: then A does not wait for b_out.
    void turn(double change, const WaveCell& out, std::size_t part) {
        const WaveCell& oldest = *m_line.arriving();
        WaveCell& stored = *m_line.leaving();
        for (int k = 0; k < WaveCell::count; ++k) stored.c[k] = m_kept * oldest.c[k];
        stored.c[0] += change;
        pass(change, change * (2 * out.mean() + change), part);
    }

    double held() const { return m_held; }                     ///< B = ∫ content
    double square() const { return m_square - headEnergy(); }  ///< Q = ∫ content²
    /// Returns ∫ 2λ(Q − B²/2T) dt since the filling, plus the losses of the projections.
    double lost() const { return m_lost + headEnergy(); }

    // For what compares and moves states

    std::span<const WaveCell> stored() const { return m_line.content(); }
    std::span<WaveCell> stored() { return m_line.content(); }
    double mean() const { return m_mean; }  ///< A, which counts where there is a loss
    /// Moves c and A to `share` of the difference to another line, and B accordingly, for consistency.
    void approach(const LossyLine& other, double share, std::span<const double> widths) {
        const auto others = other.stored();
        const auto own = stored();
        double moved = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            for (int k = 0; k < WaveCell::count; ++k)
                own[i].c[k] = others[i].c[k] + share * (own[i].c[k] - others[i].c[k]);
            // the oldest one is first
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
        m_oldestSquare = m_line.arriving()->meanSquare();
        m_next = isLossy() ? other.m_next + share * (m_next - other.m_next) : m_mean;
    }
    /// Adds a wave to all stored ones.
    void displace(double wave) {
        for (WaveCell& cell : stored()) {
            cell.c[0] += wave;
            wave = -0.7 * wave;  // not what a mean would take
        }
    }

  private:
    DelayLine<WaveCell> m_line;
    CellShift m_shift;          ///< by the difference of the stored cells to a round trip
    double m_oldestSquare = 0;  ///< of the oldest cell
    double m_headAtFilling = 0;
    double m_projected = 0;  ///< squares of the oldest cell less those that have arrived
    double m_roundTrip = 1;  ///< 2T
    double m_ofRoundTrip = 1;
    double m_kept = 1;  ///< 1 − η
    double m_rate = 0;  ///< λ
    /// Coefficients of a part of a cell.
    struct Part {
        double width;           ///< Δ
        double loss;            ///< 2λΔ
        double nextKept;        ///< e^−λΔ of the part after it: factor of A for the next A; also …
        double ofHeld, ofFlux;  ///< … factors of B before this part, and of B' over it
    };
    /// Ends a part with the means B' and Q'. The next A is ready as soon as B' is, because every node waits
    /// for it.
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

    /// Energy of the part of the oldest cell that has arrived; the sums count it with the whole cell.
    double headEnergy() const {
        if (!m_shift.isShifted()) return 0;
        const double head = m_shift.headSquare(*m_line.arriving());
        return m_kept * m_kept * m_parts.front().width * head - m_headAtFilling;
    }

    std::vector<Part> m_parts;
    double m_mean = 0, m_next = 0;    ///< A before and after the next part
    double m_held = 0, m_square = 0;  ///< B, Q
    double m_lost = 0;
};

}  // namespace drillwave
