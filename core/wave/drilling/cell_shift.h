// SPDX-License-Identifier: GPL-3.0-or-later
// A wave read at an offset of a fraction of a cell: the least-squares projection of two stored cells.
#pragma once

#include <array>
#include <cmath>

#include "core/numeric/gauss_rule.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// Two cells that follow each other, seen from `share` of the first one on over the width of a cell:
///
///     s(u) = old(u + θ) for u < 1 − θ, next(u − 1 + θ) behind,   0 ≤ θ < 1
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

}  // namespace drillwave
