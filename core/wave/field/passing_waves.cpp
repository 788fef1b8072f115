// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/passing_waves.h"

#include <utility>

#include "core/wave/exact/passing_march.h"
#include "core/wave/field/rod_instants.h"

namespace drillwave {

namespace {

/// `from` without the pieces before `first`.
PiecewisePolynomial tailOf(const PiecewisePolynomial& from, std::size_t first) {
    PiecewisePolynomial tail;
    const auto pieces = from.pieces();
    tail.clear(first < pieces.size() ? pieces[first].start : from.end());
    for (std::size_t i = first; i < pieces.size(); ++i)
        tail.append(pieces[i].length, pieces[i].scale, from.coefficients(pieces[i]));
    return tail;
}

void keepLarger(RodForce& largest, const RodForce& other) {
    if (other.size > largest.size) largest = other;
}

}  // namespace

PassingWaves::PassingWaves(const Impact& solved, const PulseForce& pulse, const RodForceChoice& choice)
    : m_pulse(pulse), m_choice(choice), m_window(solved), m_peaks(solved.peakForce) {}

std::size_t PassingWaves::take(Impact& recording) {
    look(recording, {m_choice.compression, m_choice.tension, false});
    // at the end of the blow waves meet that are up to one and a half round trips apart
    constexpr double roundTripsKept = 2;
    const double from = m_window.incident.end() - roundTripsKept * m_window.roundTrip;
    const std::size_t first = firstPieceUntil(m_window, from);
    recording.incident = tailOf(m_window.incident, first);
    recording.force = tailOf(m_window.force, first);
    m_seen = recording.incident.pieces().size();
    return m_seen + piecesHandedOver;
}

void PassingWaves::takeLast(Impact& recording) {
    look(recording, m_choice);
}

void PassingWaves::look(Impact& recording, const RodForceChoice& choice) {
    m_window.incident = std::move(recording.incident);
    m_window.force = std::move(recording.force);
    m_window.skips = recording.skips;
    const auto pieces = m_window.force.pieces();
    for (std::size_t i = m_seen; i < pieces.size(); ++i) m_peaks.add(m_window.force, pieces[i]);
    const RodForces found = largestRodForces(m_window, m_pulse, choice);
    keepLarger(m_forces.compression, found.compression);
    keepLarger(m_forces.tension, found.tension);
    m_forces.compressionAfter = found.compressionAfter;
    m_forces.tensionAfter = found.tensionAfter;
}

}  // namespace drillwave
