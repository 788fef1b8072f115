// SPDX-License-Identifier: GPL-3.0-or-later
// A wave over one cell of time: a polynomial of degree 3 that keeps its moments.
#pragma once

#include <array>
#include <cmath>

#include "core/numeric/gauss_rule.h"

namespace drillwave {

/// f(u) = Σ c_k P_k(2u − 1) over 0 ≤ u ≤ 1, P_k of Legendre. Its moments ∫f u^k du, k = 0 … 3, are those of
/// the wave that it represents: the rest is orthogonal to the cubics (strings §11).
struct WaveCell {
    static constexpr int count = 4;
    using Powers = std::array<double, count>;  ///< p(u) = Σ p_k u^k
    std::array<double, count> c{};

    static WaveCell constant(double value) { return {{value, 0, 0, 0}}; }
    /// Converts p(u) = Σ p_k u^k.
    static WaveCell fromPowers(const Powers& p) {
        WaveCell f;
        f.c[3] = p[3] / 20;
        f.c[2] = (p[2] + 30 * f.c[3]) / 6;
        f.c[1] = (p[1] + 6 * f.c[2] - 12 * f.c[3]) / 2;
        f.c[0] = p[0] + f.c[1] - f.c[2] + f.c[3];
        return f;
    }
    Powers powers() const {
        return {c[0] - c[1] + c[2] - c[3], 2 * c[1] - 6 * c[2] + 12 * c[3], 6 * c[2] - 30 * c[3], 20 * c[3]};
    }

    double start() const { return c[0] - c[1] + c[2] - c[3]; }
    double end() const { return c[0] + c[1] + c[2] + c[3]; }
    double value(double u) const {
        const double x = 2 * u - 1;
        return c[0] + c[1] * x + c[2] * (1.5 * x * x - 0.5) + c[3] * (2.5 * x * x - 1.5) * x;
    }
    double mean() const { return c[0]; }
    /// ∫f g du. Every node takes it in every cell, and a division is as long as four products.
    double meanProduct(const WaveCell& g) const {
        constexpr double third = 1.0 / 3, fifth = 1.0 / 5, seventh = 1.0 / 7;
        return (c[0] * g.c[0] + third * (c[1] * g.c[1])) +
               (fifth * (c[2] * g.c[2]) + seventh * (c[3] * g.c[3]));
    }
    double meanSquare() const { return meanProduct(*this); }  ///< ∫f² du
    /// ∫u f du.
    double firstMoment() const { return c[0] / 2 + c[1] / 6; }
    /// Returns an upper bound of |f − mean|.
    double spread() const { return std::abs(c[1]) + std::abs(c[2]) + std::abs(c[3]); }
    /// More than |f| can be.
    double largest() const { return std::abs(c[0]) + spread(); }
    /// Lower and upper bound.
    double least() const { return c[0] - spread(); }
    double most() const { return c[0] + spread(); }

    /// Place and value of the maximum of f in the cell.
    struct Peak {
        double place;
        double value;
    };
    Peak peak() const {
        Peak best = start() >= end() ? Peak{0, start()} : Peak{1, end()};
        if (std::abs(c[1]) >= 3 * std::abs(c[2]) + 6 * std::abs(c[3])) return best;  // monotonic
        // f' = c1 − 3/2 c3 + 3 c2 x + 15/2 c3 x² over x = 2u − 1
        const double a = 7.5 * c[3], b = 1.5 * c[2], constant = c[1] - 1.5 * c[3];
        const double discriminant = b * b - a * constant;
        if (discriminant < 0) return best;
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        for (const double x : {q / a, constant / q}) {
            if (!(std::abs(x) < 1)) continue;
            const double u = (x + 1) / 2;
            if (value(u) > best.value) best = {u, value(u)};
        }
        return best;
    }

    /// Returns the same function over [from, to] of this cell.
    WaveCell part(double from, double to) const {
        Powers p = powers();
        for (int i = 0; i + 1 < count; ++i)
            for (int k = count - 2; k >= i; --k) p[k] += from * p[k + 1];
        const double width = to - from;
        double power = 1;
        for (double& coefficient : p) coefficient *= power, power *= width;
        return fromPowers(p);
    }

    bool operator==(const WaveCell&) const = default;
    WaveCell& operator+=(const WaveCell& g) {
        for (int k = 0; k < count; ++k) c[k] += g.c[k];
        return *this;
    }
    friend WaveCell operator+(WaveCell f, const WaveCell& g) { return f += g; }
    friend WaveCell operator-(const WaveCell& f, const WaveCell& g) {
        WaveCell h;
        for (int k = 0; k < count; ++k) h.c[k] = f.c[k] - g.c[k];
        return h;
    }
    friend WaveCell operator*(double factor, WaveCell f) {
        for (double& coefficient : f.c) coefficient *= factor;
        return f;
    }
};

/// Projects a wave that is known in parts to the cell of the same moments.
class CellProjection {
  public:
    /// f over [from, to] of the cell, smooth there; a polynomial of degree 28 is taken exactly.
    template <class Function>
    void add(double from, double to, Function f) {
        const GaussRule& rule = gaussRule();
        for (std::size_t i = 0; i < GaussRule::count; ++i) {
            const double u = from + (to - from) * rule.nodes[i];
            const double weighted = (to - from) * rule.weights[i] * f(u);
            const double x = 2 * u - 1;
            m_cell.c[0] += weighted;
            m_cell.c[1] += 3 * weighted * x;
            m_cell.c[2] += 5 * weighted * (1.5 * x * x - 0.5);
            m_cell.c[3] += 7 * weighted * (2.5 * x * x - 1.5) * x;
        }
    }
    const WaveCell& cell() const { return m_cell; }

  private:
    WaveCell m_cell;
};

// Events inside a cell: which of them cut the cells, and what is only rounding.

/// Distance from an event, as a multiple of its own changes, above which a cell is taken as a whole: more
/// than its projection moves it.
inline constexpr double quietMargin = 1e-3;

/// Rate times width above which a rise is too fast for a cell.
inline constexpr double fastRise = 0.4;

/// Maximum number of events at one point of a cell: a state that balances after that many stays there.
inline constexpr int mostStanding = 4;

/// Sets coefficients to zero that are of the size of rounding.
inline void dropRounding(double* c, int count, double rounding) {
    for (int k = 0; k < count; ++k)
        if (std::abs(c[k]) <= rounding) c[k] = 0;
}

/// Which events cut the cells.
enum class CutAt {
    nothing,
    jumps,   ///< contacts whose force rises too fast for a cell
    corners  ///< whatever bends a wave: then all cells are smooth
};

/// Place to cut a cell: the first one that counts.
struct CellJump {
    bool found = false;
    double place = 0;  ///< in the cell, 0 … 1

    /// An event at a place of the cell.
    void offer(CutAt cutAt, bool isJump, double at) {
        constexpr double nearest = 1e-9;  // nearer to its ends a cell is not cut
        if (found || at <= nearest || at >= 1 - nearest) return;
        if (cutAt == CutAt::corners || (cutAt == CutAt::jumps && isJump)) *this = {true, at};
    }
};

}  // namespace drillwave
