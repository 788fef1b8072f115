// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/closed/decay_pieces.h"

#include <algorithm>
#include <span>

#include "core/numeric/power_series.h"

namespace drillwave {

namespace {

using Series = PowerSeries<double>;

/// The first 22 terms on [0, length], βℓ ≤ 1: the rest is below 1e-21 of the coefficients.
Series seriesOf(const Decay& f, double beta, double length) {
    constexpr int terms = 22;
    Series series = Series::zero(length);
    series.count = terms;
    double power = 1, before = 0;  // (−βℓ)^k/k! and the one before
    for (int k = 0; k < terms; ++k) {
        series.c[k] = f.amplitude * power + f.growth * length * before;
        before = power;
        power *= -beta * length / (k + 1);
    }
    series.c[0] += f.constant;
    series.trim(0);
    return series;
}

bool isDecayed(const Decay& f) {
    constexpr double nothing = 1e-22;
    return std::abs(f.amplitude) + std::abs(f.growth) < nothing;
}

}  // namespace

void DecayPieces::append(double length, Decay incident, Decay force) {
    while (length > 0) {
        const bool isConstant = isDecayed(incident) && isDecayed(force);
        const double piece = isConstant ? length : std::min(length, 1 / m_beta);
        if (isConstant) incident = {incident.constant, 0, 0}, force = {force.constant, 0, 0};
        appendPiece(piece, incident, force);
        incident = incident.from(piece, m_beta);
        force = force.from(piece, m_beta);
        length -= piece;
    }
}

void DecayPieces::appendPiece(double length, const Decay& incident, const Decay& force) {
    const Series g = seriesOf(incident, m_beta, length);
    const Series f = seriesOf(force, m_beta, length);
    ++m_count;
    m_momentum += g.integral(length);
    m_energy += Series::productIntegral(g, g, length);
    m_rockWork += 2 * Series::productIntegral(f, g, length) - Series::productIntegral(f, f, length);
    if (!m_impact) return;
    const auto coefficients = [](const Series& series) {
        return std::span(series.c.data(), static_cast<std::size_t>(series.count));
    };
    m_impact->incident.append(length, length, coefficients(g));
    m_impact->force.append(length, length, coefficients(f));
}

}  // namespace drillwave
