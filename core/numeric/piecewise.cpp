// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/piecewise.h"

#include <algorithm>

namespace drillwave {

void PiecewisePolynomial::clear(double origin) {
    m_pieces.clear();
    m_coefficients.clear();
    m_integrals.clear();
    m_origin = origin;
    m_end = origin;
}

void PiecewisePolynomial::append(double length, double scale, std::span<const double> coefficients) {
    if (m_pieces.capacity() == 0) {  // most histories need no more than that
        constexpr std::size_t usualPieces = 128, usualTerms = 24;
        m_pieces.reserve(usualPieces);
        m_integrals.reserve(usualPieces);
        m_coefficients.reserve(usualPieces * usualTerms);
    }
    const double before =
        m_pieces.empty() ? 0.0 : m_integrals.back() + integral(m_pieces.back(), m_pieces.back().length);
    m_pieces.push_back({m_end, length, scale, static_cast<std::uint32_t>(m_coefficients.size()),
                        static_cast<std::uint32_t>(coefficients.size())});
    m_coefficients.insert(m_coefficients.end(), coefficients.begin(), coefficients.end());
    m_integrals.push_back(before);
    m_end += length;
}

std::span<const double> PiecewisePolynomial::coefficients(const Piece& piece) const {
    return {m_coefficients.data() + piece.first, piece.count};
}

double PiecewisePolynomial::value(const Piece& piece, double x) const {
    if (x == 0) return piece.count > 0 ? m_coefficients[piece.first] : 0;
    const double u = x / piece.scale;
    double sum = 0;
    if (u == 1) {  // where most pieces end
        for (std::uint32_t k = piece.count; k-- > 0;) sum += m_coefficients[piece.first + k];
        return sum;
    }
    for (std::uint32_t k = piece.count; k-- > 0;) sum = sum * u + m_coefficients[piece.first + k];
    return sum;
}

double PiecewisePolynomial::integral(const Piece& piece, double x) const {
    const double u = x / piece.scale;
    double sum = 0;
    for (std::uint32_t k = piece.count; k-- > 0;) sum = sum * u + m_coefficients[piece.first + k] / (k + 1);
    return sum * x;
}

const PiecewisePolynomial::Piece* PiecewisePolynomial::pieceAt(double s) const {
    if (m_pieces.empty() || !(s >= m_origin) || s >= m_end) return nullptr;
    const auto after = std::upper_bound(m_pieces.begin(), m_pieces.end(), s,
                                        [](double time, const Piece& piece) { return time < piece.start; });
    return &*std::prev(after);
}

double PiecewisePolynomial::operator()(double s) const {
    const Piece* piece = pieceAt(s);
    return piece ? value(*piece, std::min(s - piece->start, piece->length)) : 0.0;
}

double PiecewisePolynomial::integral(double s) const {
    if (m_pieces.empty() || s <= m_origin) return 0;
    const Piece* piece = pieceAt(s);
    if (!piece) piece = &m_pieces.back();
    const auto index = static_cast<std::size_t>(piece - m_pieces.data());
    return m_integrals[index] + integral(*piece, std::min(s - piece->start, piece->length));
}

}  // namespace drillwave
