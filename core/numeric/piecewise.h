// SPDX-License-Identifier: GPL-3.0-or-later
// Contiguous piecewise polynomial of one variable, the form in which histories over time are stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numeric/compensated_sum.h"

namespace drillwave {

/// Function f(s) on [start, end), made of contiguous polynomials Σ c_k u^k with u = (s − start of the
/// piece)/scale. Jumps between pieces are allowed; at a jump f has the value on the right. Outside [start,
/// end) f is 0.
class PiecewisePolynomial {
  public:
    struct Piece {
        double start;  ///< value of the variable s at which the piece begins
        /// Length of the piece in the variable s, ≥ 0; the next piece begins at start + length.
        double length;
        double scale;         ///< scale of the local coordinate u = (s − start)/scale, > 0
        std::uint32_t first;  ///< index of the first coefficient of the piece in the common list
        std::uint32_t count;  ///< number of coefficients; 0 for a piece that is exactly zero
    };

    /// Adds a piece at the end; the first piece begins at the origin set by clear(). The piece is Σ c_k u^k
    /// with c_k from `coefficients`, u = x/scale, and x the distance from its start.
    void append(double length, double scale, std::span<const double> coefficients);
    void clear(double origin = 0);

    bool empty() const { return m_pieces.empty(); }
    double start() const { return m_origin; }
    double end() const { return m_end; }
    std::span<const Piece> pieces() const { return m_pieces; }
    std::span<const double> coefficients(const Piece& piece) const;

    double operator()(double s) const;
    /// Returns the value of one piece of the function at the distance x from the start of the piece, 0 ≤ x ≤
    /// length.
    double value(const Piece& piece, double x) const;
    /// Returns the integral of one piece of the function from its start to the distance x, 0 ≤ x ≤ length.
    double integral(const Piece& piece, double x) const;
    /// Returns the integral of the function from start() to s.
    double integral(double s) const;

  private:
    const Piece* pieceAt(double s) const;

    std::vector<Piece> m_pieces;
    std::vector<double> m_coefficients;
    std::vector<double> m_integrals;  // integral up to the start of each piece
    double m_origin = 0;
    /// End of the function: its start plus the lengths of all pieces. The sum compensates rounding errors,
    /// so that the borders of the pieces are found exactly.
    CompensatedSum<double> m_end;
};

}  // namespace drillwave
