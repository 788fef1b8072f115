// SPDX-License-Identifier: GPL-3.0-or-later
// A contiguous piecewise polynomial of one variable: how histories are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numeric/compensated_sum.h"

namespace drillwave {

/// f(s) on [start, end): contiguous pieces, each Σ c_k u^k with u = (s − start of the piece)/scale of the
/// piece. Jumps between pieces are allowed; evaluation is right-continuous. Outside [start, end) the value is
/// 0.
class PiecewisePolynomial {
  public:
    struct Piece {
        double start;         ///< where the piece begins
        double length;        ///< ≥ 0; the next piece begins at start + length
        double scale;         ///< u = (s − start)/scale, > 0
        std::uint32_t first;  ///< index of its first coefficient
        std::uint32_t count;  ///< number of coefficients, 0 for an exactly zero piece
    };

    /// Appends a piece behind the last one; the first piece begins at `origin`.
    void append(double length, double scale, std::span<const double> coefficients);
    void clear(double origin = 0);

    bool empty() const { return m_pieces.empty(); }
    double start() const { return m_origin; }
    double end() const { return m_end; }
    std::span<const Piece> pieces() const { return m_pieces; }
    std::span<const double> coefficients(const Piece& piece) const;

    double operator()(double s) const;
    /// Value of one piece at local distance x from its start, 0 ≤ x ≤ length.
    double value(const Piece& piece, double x) const;
    /// ∫ of one piece from its start to local distance x.
    double integral(const Piece& piece, double x) const;
    /// ∫ from start() to s.
    double integral(double s) const;

  private:
    const Piece* pieceAt(double s) const;

    std::vector<Piece> m_pieces;
    std::vector<double> m_coefficients;
    std::vector<double> m_integrals;  // up to the start of each piece
    double m_origin = 0;
    CompensatedSum<double> m_end;  ///< of many lengths: a look-up is as sharp as a time can be
};

}  // namespace drillwave
