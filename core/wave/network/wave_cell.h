// SPDX-License-Identifier: GPL-3.0-or-later
// Wave over one cell (time step): a polynomial of degree 3 with the moments of the wave.
#pragma once

#include <array>
#include <cmath>

#include "core/numeric/gauss_rule.h"

namespace drillwave {

/// Cubic polynomial for a wave over one cell (time step): f(u) = Σ c_k P_k(2u − 1) for 0 ≤ u ≤ 1 with
/// Legendre polynomials P_k. Its moments ∫f u^k du, k = 0 … 3, equal those of the exact wave (strings §11).
struct WaveCell {
    /// Number of coefficients of a cubic polynomial.
    static constexpr int count = 4;
    /// Coefficients p_k of a cubic as powers of u, p(u) = Σ p_k u^k, with 0 ≤ u ≤ 1 over a cell (time step).
    using Powers = std::array<double, count>;
    /// Coefficients c_k of the wave f(u) = Σ c_k P_k(2u − 1) over the cell (time step), with Legendre
    /// polynomials P_k.
    std::array<double, count> c{};

    /// Returns a wave of the constant value `value` over the cell (time step).
    static WaveCell constant(double value) { return {{value, 0, 0, 0}}; }
    /// Returns the wave f(u) = Σ p_k u^k, 0 ≤ u ≤ 1 over the cell (time step).
    static WaveCell fromPowers(const Powers& p) {
        WaveCell f;
        f.c[3] = p[3] / 20;
        f.c[2] = (p[2] + 30 * f.c[3]) / 6;
        f.c[1] = (p[1] + 6 * f.c[2] - 12 * f.c[3]) / 2;
        f.c[0] = p[0] + f.c[1] - f.c[2] + f.c[3];
        return f;
    }
    /// Returns the coefficients p_k of the wave as a sum of powers, f(u) = Σ p_k u^k.
    Powers powers() const {
        return {c[0] - c[1] + c[2] - c[3], 2 * c[1] - 6 * c[2] + 12 * c[3], 6 * c[2] - 30 * c[3], 20 * c[3]};
    }

    /// Returns the value of the wave at the start of the cell (time step), u = 0.
    double start() const { return c[0] - c[1] + c[2] - c[3]; }
    /// Returns the value of the wave at the end of the cell (time step), u = 1.
    double end() const { return c[0] + c[1] + c[2] + c[3]; }
    /// Returns the value of the wave at the fraction u of the cell (time step), 0 ≤ u ≤ 1.
    double value(double u) const {
        const double x = 2 * u - 1;
        return c[0] + c[1] * x + c[2] * (1.5 * x * x - 0.5) + c[3] * (2.5 * x * x - 1.5) * x;
    }
    /// Returns the mean of the wave over the cell (time step), ∫f du.
    double mean() const { return c[0]; }
    /// Returns the mean of the product of this wave and the wave g, ∫f g du. It is written without divisions,
    /// because every node (end of a section) computes it in every cell.
    double meanProduct(const WaveCell& g) const {
        constexpr double third = 1.0 / 3, fifth = 1.0 / 5, seventh = 1.0 / 7;
        return (c[0] * g.c[0] + third * (c[1] * g.c[1])) +
               (fifth * (c[2] * g.c[2]) + seventh * (c[3] * g.c[3]));
    }
    /// Returns the mean of the square of the wave, ∫f² du.
    double meanSquare() const { return meanProduct(*this); }
    /// Returns the first moment of the wave, ∫u f du, with the fraction u of the cell.
    double firstMoment() const { return c[0] / 2 + c[1] / 6; }
    /// Returns an upper bound of |f − mean of f| over the cell (time step).
    double spread() const { return std::abs(c[1]) + std::abs(c[2]) + std::abs(c[3]); }
    /// Returns an upper bound of the absolute value of the wave over the cell (time step).
    double largest() const { return std::abs(c[0]) + spread(); }
    /// Returns a lower bound of the wave over the cell (time step).
    double least() const { return c[0] - spread(); }
    /// Returns an upper bound of the wave over the cell (time step).
    double most() const { return c[0] + spread(); }

    /// Maximum of the wave f in a cell (time step): its position u, 0 … 1, and its value.
    struct Peak {
        double place;
        double value;
    };
    /// Returns the maximum of the wave over the cell (time step), and its position.
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

    /// Returns the wave over the part from ≤ u ≤ to of this cell (time step), as a cell of its own.
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

/// Computation of the cubic that has the same moments as a given wave over a cell (time step). The wave is
/// given as functions on parts of the cell.
class CellProjection {
  public:
    /// Adds a part of the wave: the function f(u) over from ≤ u ≤ to, which must be smooth there. A
    /// polynomial up to degree 28 is integrated exactly.
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
    /// Returns the cubic that has the same moments as all added parts together.
    const WaveCell& cell() const { return m_cell; }

  private:
    WaveCell m_cell;
};

// Events inside a cell: rules for which of them cut the cells, and which are only rounding

/// Safety margin for deciding that a cell (time step) has no contact event, as a share of the wave's
/// variation over the cell. If the event is farther away than this, the cell is computed as a whole. Its
/// projection to a cubic changes the wave by less.
inline constexpr double quietMargin = 1e-3;

/// Product of the rate of a force and the width of a cell (time step) above which the force rises too fast
/// for one cubic.
inline constexpr double fastRise = 0.4;

/// Maximum number of contact events at the same instant within a cell (time step). After so many events, the
/// contact is assumed to keep its state for the rest of the cell.
inline constexpr int mostStanding = 4;

/// Sets all coefficients with an absolute value of at most `rounding` to zero.
inline void dropRounding(double* c, int count, double rounding) {
    for (int k = 0; k < count; ++k)
        if (std::abs(c[k]) <= rounding) c[k] = 0;
}

/// Kinds of contact events inside a cell (time step) at which all cells are divided, so that waves jump or
/// bend only between parts.
enum class CutAt {
    /// No contact event divides the cells (time steps).
    nothing,
    /// Cells (time steps) are divided at contacts after which a force rises too fast for one cubic over a
    /// cell.
    jumps,
    /// Cells (time steps) are divided at all events that bend a wave, so that waves are smooth in every part.
    corners
};

/// First event in a cell (time step) at which all cells are to be divided.
struct CellJump {
    /// Whether an event was found at which all cells (time steps) are to be divided.
    bool found = false;
    /// Point at which all cells (time steps) are to be divided, as a fraction of a cell from its beginning, 0
    /// … 1.
    double place = 0;

    /// Requests that all cells (time steps) be divided at the fraction `at`, where an event happens. `isJump`
    /// says that the force then rises too fast for one cubic. The request is ignored if `cutAt` excludes this
    /// kind of event, if an earlier event is recorded, or at an end of the cell.
    void offer(CutAt cutAt, bool isJump, double at) {
        constexpr double nearest = 1e-9;  // nearer to its ends a cell is not cut
        if (found || at <= nearest || at >= 1 - nearest) return;
        if (cutAt == CutAt::corners || (cutAt == CutAt::jumps && isJump)) *this = {true, at};
    }
};

}  // namespace drillwave
