// How ContactMarch takes the next arriving piece and passes it through contact. Included by contact_march.h
// only.
#pragma once

#include <algorithm>
#include <limits>

#include "core/wave/contact_march.h"

namespace drillwave {

/// Whether a piece is but the rounding between two breakpoints that coincide; its impulse counts as error.
template <class Basis>
bool ContactMarch<Basis>::isSliver(const Piece& piece) {
    const Real coincident = 4 * std::numeric_limits<Real>::epsilon() * (m_roundTrip + m_hammerTime);
    if (piece.length > coincident) return false;
    const Real impulse = piece.magnitude() * piece.length;
    if (impulse > std::numeric_limits<Real>::epsilon() / 2) return false;
    m_error += impulse;
    return true;
}

/// Takes the next piece of the incident wave and adds the hammer force that arrives with it. Ends of pieces
/// that coincide within rounding are taken as one.
template <class Basis>
void ContactMarch<Basis>::nextArrival() {
    while (m_waves.size() > 1 && isSliver(m_waves.front())) m_waves.popFront();
    m_incident = m_waves.front();
    if (m_hammerPiece >= m_pulse->segments.size()) {
        m_waves.popFront();
        return;
    }
    const Real coincident = 4 * std::numeric_limits<Real>::epsilon() * (1 + m_hammerTime);
    const PulseSegment& segment = m_pulse->segments[m_hammerPiece];
    const Real into = m_hammerTime - Real(segment.start);
    const Real left = std::max(Real(segment.length) - into, coincident);
    const Real length = std::min(m_basis.hammerPieceLength(segment, left), m_incident.length);
    if (m_incident.length > length) {
        m_waves.front().dropFront(length);
        m_incident.shorten(length);
    } else {
        m_waves.popFront();
    }
    const Piece& hammer = m_basis.addHammer(segment, into, length, m_incident);
    if constexpr (Basis::keepsHistory)
        if (m_detail != Detail::cor)  // Fa va = Fa (2g − Fa)
            m_impact->hammerWork += double(2 * Basis::productIntegral(hammer, m_incident, length) -
                                           Basis::productIntegral(hammer, hammer, length));
    m_hammerTime += length;
    if (left - length <= coincident) {
        ++m_hammerPiece;
        m_hammerTime = m_hammerPiece < m_pulse->segments.size() ? Real(m_pulse->segments[m_hammerPiece].start)
                                                                : Real(m_pulse->end);
    }
}

template <class Basis>
void ContactMarch<Basis>::closeGap() {
    m_gap = 0;
    m_force = 0;
    m_phase = m_elasticRock || m_peak == 0 ? Phase::primary : Phase::elastic;
    if (!m_touching) {
        ++m_impact->contacts;
        m_contactStart = m_s;
        note(ContactEvent::contact);
        if (!m_everTouched) m_impact->firstContactTime = double(m_arrival + m_s);
    }
    m_touching = false;
    m_everTouched = true;
}

template <class Basis>
void ContactMarch<Basis>::separate() {
    m_touching = false;
    m_impact->contactDuration += double(m_s - m_contactStart);
    m_impact->separationTime = double(m_arrival + m_s);
    note(ContactEvent::separation);
}

/// A stretch of the front end has passed: its reflected wave goes back into the rod.
template <class Basis>
void ContactMarch<Basis>::leave(const Piece& reflected, const Piece& incident, const Piece* force,
                                Real length) {
    ++m_impact->pieces;
    m_s += length;
    if (length <= 0) return;
    if constexpr (Basis::keepsHistory)
        if (m_detail == Detail::histories) m_basis.record(incident, force, length, *m_impact);
    if constexpr (Basis::keepsHistory)
        if (m_waves.size() > Basis::manyPieces) {
            Piece last = reflected;
            last.shorten(length);
            m_basis.tidy(last);
            if (m_basis.join(m_waves.back(), last, m_error)) return;
        }
    m_waves.pushBack(reflected);
    m_waves.back().shorten(length);
    m_basis.tidy(m_waves.back());
}

/// While the hammer still pushes: the front end is free until the gap is closed.
template <class Basis>
void ContactMarch<Basis>::advanceApart() {
    const auto contact = m_basis.gapClosure(m_incident, m_gap);
    if (!contact.found) {
        if (m_touching && !m_incident.isZero()) separate();
        if (!m_touching) m_gap -= 2 * m_incident.integral(m_incident.length);
        leave(m_incident, m_incident, nullptr, m_incident.length);
        m_incident.length = 0;
        return;
    }
    if (contact.u > 0) {
        if (m_touching) separate();
        leave(m_incident, m_incident, nullptr, contact.u);
        m_incident.dropFront(contact.u);
    }
    closeGap();
}

/// Contact over the piece now arriving, up to the first event or its end.
template <class Basis>
void ContactMarch<Basis>::advanceContact() {
    const Real rate = m_phase == Phase::primary ? m_beta : m_unloadingRate;
    if (m_incident.isZero() && m_force <= m_basis.negligibleForce()) {
        m_force = 0;  // forceless contact: what is left of an exponential is rounding
        m_phase = Phase::apart;
        m_touching = true;
        m_gap = 0;
        return;
    }
    auto& response = m_basis.respond(m_incident, rate, m_force);
    if (m_basis.failed()) return;
    Real length = response.length;
    enum class Ending { none, separation, unloading, primaryLoading } ending = Ending::none;
    if (m_elasticRock) {
        if (const auto zero = m_basis.forceVanishes(response); zero.found) {
            length = zero.u;
            ending = Ending::separation;
        }
    } else if (m_phase == Phase::primary) {
        if (const auto zero = m_basis.driveVanishes(response); zero.found) {
            length = zero.u;
            ending = Ending::unloading;
        }
    } else {
        if (const auto zero = m_basis.forceVanishes(response); zero.found) {
            length = zero.u;
            ending = Ending::separation;
        }
        if (const auto zero = m_basis.forceReaches(response, m_peak, m_justUnloaded); zero.found)
            if (ending == Ending::none || zero.u < length) {
                length = zero.u;
                ending = Ending::primaryLoading;
            }
    }
    if (m_basis.failed()) return;
    m_stillEvents = length > 0 ? 0 : m_stillEvents + 1;
    if (m_stillEvents > 1) m_basis.stall();
    if (m_basis.failed()) return;
    if (m_stillEvents > 3 &&
        ending != Ending::separation) {  // branches that differ by rounding only: either will do
        ending = Ending::none;
        length = response.length;
        if (m_phase == Phase::primary) m_peak = std::max(m_peak, response.force.value(length));
    }

    m_basis.endAt(response, length);
    m_impulse += response.force.integral(length);
    m_error += m_basis.roundingError(response, length);
    if constexpr (Basis::keepsHistory)
        if (m_detail != Detail::cor) {
            m_impact->rockWork += double(Basis::productIntegral(response.force, response.drive, length));
            if (m_elasticRock) m_peak = std::max(m_peak, m_basis.largest(response, length));
        }
    const Real force = response.force.value(length);
    leave(response.reflected, response.incident, &response.force, length);
    if (length < m_incident.length)
        m_basis.dropFront(m_incident, response);
    else
        m_incident.length = 0;
    if (length > 0) m_justUnloaded = false;
    switch (ending) {
        case Ending::none:
            m_force = force;
            break;
        case Ending::separation:
            m_force = 0;
            m_gap = 0;
            m_phase = Phase::apart;
            separate();
            break;
        case Ending::unloading:
            m_force = m_peak = std::max(force, m_peak);
            m_phase = Phase::elastic;
            m_justUnloaded = length > 0;  // at a jump of g, F' is negative at once
            note(ContactEvent::unloading);
            break;
        case Ending::primaryLoading:
            m_force = m_peak;
            m_phase = Phase::primary;
            note(ContactEvent::primaryLoading);
            break;
    }
}

}  // namespace drillwave
