// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of ContactMarch: taking the next arriving piece of the wave, and its passage through contact.
// Included by contact_march.h only.
#pragma once

#include <algorithm>
#include <limits>

#include "core/wave/exact/contact_march_state.h"

namespace drillwave {

/// Returns whether a piece of the wave is so short that it is only due to rounding, between two breakpoints
/// that should coincide. The impulse of such a piece is added to the error.
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
/// that coincide within rounding are merged.
template <class Basis>
void ContactMarch<Basis>::nextArrival() {
    while (m_waves.size() > 1 && isSliver(m_waves.front())) m_waves.popFront();
    if (hammerHasEnded()) {
        m_waves.take();
        return;
    }
    const Real coincident = 4 * std::numeric_limits<Real>::epsilon() * (1 + m_hammerTime);
    const PulseSegment& segment = m_pulse->segments[m_hammerPiece];
    const Real into = m_hammerTime - Real(segment.start);
    const Real left = std::max(Real(segment.length) - into, coincident);
    Piece& front = m_waves.front();
    const Real length = std::min(m_basis.hammerPieceLength(segment, left), front.length);
    if (front.length > length) {
        incident() = front;
        front.dropFront(length);
        incident().shorten(length);
    } else {
        m_waves.take();
    }
    if (m_detail != Detail::cor) m_impact->hammerWork += double(hammerWork(segment, into, length));
    m_basis.addHammer(segment, into, length, incident());
    m_hammerTime += length;
    if (left - length <= coincident) {
        ++m_hammerPiece;
        m_hammerTime = hammerHasEnded() ? Real(m_pulse->end) : Real(m_pulse->segments[m_hammerPiece].start);
    }
}

/// Returns the work of the hammer ∫Fa va dt = ∫Fa (Fa + 2g) dt over the next `length` of the hammer force
/// [paper (1)], in units of I0²/(Z t0). g is the wave that returns to the hammer; it is the piece now
/// arriving at the front end.
template <class Basis>
typename ContactMarch<Basis>::Real ContactMarch<Basis>::hammerWork(const PulseSegment& segment, Real into,
                                                                   Real length) {
    const Real alone = Real(segment.energyOf(double(into), double(length)));
    return incident().isZero() ? alone : alone + 2 * m_basis.hammerProduct(segment, into, incident(), length);
}

/// Starts contact at the time when the gap closes: after the first `length` [t0] of the piece `arriving` of
/// the wave.
template <class Basis>
void ContactMarch<Basis>::closeGap(const Piece& arriving, Real length) {
    m_opened = std::max(m_opened, m_gap + 2 * arriving.magnitude() * length);
    m_error += m_gapError;
    m_gapError = 0;
    const bool wasClosed = m_everTouched && m_opened <= closedGap;
    m_gap = 0;
    m_force = 0;
    m_line = m_law.lineAtContact();
    if (!m_touching && wasClosed) {
        rejoin();
    } else if (!m_touching) {
        ++m_impact->contacts;
        note(ContactEvent::contact);
        if (m_everTouched)
            m_closingSpeed = 2 * arriving.value(length);
        else
            m_impact->firstContactTime = double(m_arrival + m_s);
        m_contactForce = 0;
    }
    m_touching = false;
    m_everTouched = true;
}

/// Moves the free front end of the rod by twice the impulse of the wave that arrived, which changes the gap
/// to the rock. Adds the rounding error of this displacement.
template <class Basis>
void ContactMarch<Basis>::drift(const Piece& arriving, Real impulse) {
    m_gap += -2 * impulse;
    m_gapError += 2 * std::numeric_limits<Real>::epsilon() * m_basis.impulseSize(arriving);
    m_opened = std::max(m_opened, Real(m_gap));
}

template <class Basis>
void ContactMarch<Basis>::separate() {
    m_touching = false;
    m_opened = 0;
    // A gap that errs by δ closes δ/(closing speed) early or late, and shifts the force by as much: the
    // impulse that this displaces is at most 2 Fmax times that.
    if (m_impact->contacts > 1 && m_contactForce > 0)
        m_growth *= 1 + 2 * m_contactForce / std::max(m_closingSpeed, Real(0));
    if (m_detail == Detail::cor) m_nextProof = m_s + m_roundTrip;  // else the hammer work is needed
    m_separatedBefore = m_impact->separationTime;
    m_impact->separationTime = double(m_arrival + m_s);
    note(ContactEvent::separation);
}

/// Removes the last separation of bit and rock from the result, because the gap did not open by more than
/// rounding.
template <class Basis>
void ContactMarch<Basis>::rejoin() {
    m_impact->separationTime = m_separatedBefore;
    if (m_detail >= Detail::events) m_impact->events.pop_back();
}

/// Advances the front end of the rod by a stretch of time of the given length [t0], and records waves and
/// force if histories are requested.
template <class Basis>
void ContactMarch<Basis>::pass(const Piece& incident, const Piece* force, Real length) {
    ++m_impact->pieces;
    m_s += length;
    if (force || m_touching) m_contactTime += length;
    if (!force && length > 0) m_eventsOnTheSpot = 0;
    if (m_detail == Detail::histories && length > 0) [[unlikely]] {
        m_basis.record(incident, force, length, *m_impact);
        if (m_limits.handOver && m_impact->incident.pieces().size() >= m_nextHandOver)
            m_nextHandOver = (*m_limits.handOver)(*m_impact);
    }
}

/// Advances the front end without contact by the first `length` [t0] of the arriving wave. Both free ends
/// reflect this part of the wave, so it is added to the waves in the rod unchanged.
template <class Basis>
void ContactMarch<Basis>::leaveFree(Real length) {
    pass(incident(), nullptr, length);
    if (length <= 0) return;
    Piece& back = m_waves.pushBack();
    back = incident();
    back.shorten(length);
    m_basis.tidy(back);
    joinLast();
}

/// Advances the front end of the rod by a stretch of contact, and adds the wave that it reflects to the waves
/// in the rod.
template <class Basis>
void ContactMarch<Basis>::leaveContact(Response& response, Real length) {
    pass(m_basis.incidentOf(response), &response.force, length);
    if (length <= 0) return;
    Piece& back = m_waves.pushBack();
    m_basis.reflect(response, back);
    back.shorten(length);
    m_basis.tidy(back);
    joinLast();
}

/// Joins the last two pieces of the wave in the rod into one, if this saves work and is accurate enough.
template <class Basis>
void ContactMarch<Basis>::joinLast() {
    if constexpr (Basis::joinsPieces) {
        const std::size_t size = m_waves.size();
        if (size > Basis::manyPieces + 1 && m_basis.join(m_waves[size - 2], m_waves.back(), m_error))
            m_waves.popBack();
    }
}

/// Advances the free front end of the rod until the gap to the rock closes, or the arriving piece of the wave
/// ends.
template <class Basis>
void ContactMarch<Basis>::advanceApart() {
    const auto contact = m_basis.gapClosure(incident(), m_gap);
    if (!contact.found) {
        if (m_touching && !incident().isZero()) separate();
        if (!m_touching) drift(incident(), m_basis.impulse(incident()));
        leaveFree(incident().length);
        incident().length = 0;
        return;
    }
    if (contact.u > 0) {
        if (m_touching) separate();
        leaveFree(contact.u);
    }
    closeGap(incident(), contact.u);
    if (contact.u > 0) incident().dropFront(contact.u);
}

/// Returns where and how a solved stretch of contact ends: at its first event, or at its full length if there
/// is none. Fm is the largest force so far, F_j the force at corner j of the bit–rock law.
///
///     line      condition              ending           then
///     apart     the gap has closed     (closeGap)       the line of lineAtContact()
///     primary   drive 2g − F below 0   unloading        elastic, unless γ = 1
///     primary   F = 0, for γ = 1       separation       apart
///     elastic   F = 0                  separation       apart
///     elastic   F = Fm                 primaryLoading   primary
///     primary   F = F_j                corner           primary, with the slope after it
template <class Basis>
typename ContactMarch<Basis>::Stretch ContactMarch<Basis>::firstEvent(Response& response) {
    Stretch stretch{response.length, Ending::none};
    const auto endsAt = [&stretch](const auto& zero, Ending ending) {
        if (zero.found && (stretch.ending == Ending::none || zero.u < stretch.length))
            stretch = {zero.u, ending};
    };
    if (m_law.isOneWay(m_line)) {
        endsAt(m_basis.driveVanishes(response), Ending::unloading);
    } else {
        endsAt(m_basis.forceVanishes(response), Ending::separation);
        if (!m_law.isElastic())
            endsAt(m_basis.forceReaches(response, m_law.largestForce(), m_justUnloaded),
                   Ending::primaryLoading);
    }
    if (m_law.hasCorner() && m_line == ContactLine::primary) [[unlikely]]
        endsAt(m_basis.forceReaches(response, m_law.cornerForce(), false), Ending::corner);
    if (stretch.length > 0) {
        m_eventsOnTheSpot = 0;
        return stretch;
    }
    if (++m_eventsOnTheSpot > 1) m_basis.stall();
    if (m_eventsOnTheSpot > repeatedEvents && stretch.ending != Ending::separation && mayStay(response)) {
        stretch = {response.length, Ending::none};
        if (m_line == ContactLine::primary) m_law.remember(response.force.value(response.length));
        m_eventsOnTheSpot = repeatedEvents;  // events on a plateau of many pieces count as one event
    }
    return stretch;
}

/// Returns whether the contact may stay on its present line of the law although events repeat at the same
/// time. The force is then constant at its peak, and only rounding decides which line it follows. It may stay
/// until the force clearly leaves the peak.
template <class Basis>
bool ContactMarch<Basis>::mayStay(const Response& response) {
    if (m_eventsOnTheSpot > mostEventsOnTheSpot) return true;
    const Real end = response.force.value(response.length);
    const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * m_law.largestForce();
    return m_line == ContactLine::primary ? end >= m_force - rounding
                                          : end <= m_law.largestForce() + rounding;
}

/// Adds the error that joined pieces of the wave cause during one stretch of contact.
template <class Basis>
void ContactMarch<Basis>::countJoining(const Response& response, Real length, Ending ending) {
    if constexpr (Basis::joinsPieces) {
        if (m_line == ContactLine::elastic) m_basis.passElastic(length);
        if (ending == Ending::none) return;
        m_basis.passEvent(eventOf(ending), response, length, incident().length);
    }
}

/// Advances the front end of the rod in contact, up to the first contact event or the end of the arriving
/// piece of the wave.
template <class Basis>
void ContactMarch<Basis>::advanceContact() {
    if (incident().isZero() && m_force <= m_basis.negligibleForce()) {
        m_force = 0;  // contact without force: the remainder is rounding
        m_line = ContactLine::apart;
        m_touching = true;
        m_justUnloaded = false;
        m_gap = 0;
        return;
    }
    Response& response = m_basis.respond(incident(), m_law.slope(m_line), m_force);
    if (m_basis.failed()) return;
    const auto [length, ending] = firstEvent(response);
    if (m_basis.failed()) return;

    const auto end = m_basis.endAt(response, length);
    m_impulse += end.impulse;
    m_error += end.error + Basis::roundingOfSums * m_impulse;
    countJoining(response, length, ending);
    m_force = std::max(end.force, Real(0));  // a negative force is rounding
    if (m_detail != Detail::cor && m_law.isElastic()) {
        m_law.remember(m_force);
        m_law.remember(m_basis.largest(response, length, m_law.largestForce()));
    }
    m_contactForce = std::max(m_contactForce, m_force);
    leaveContact(response, length);
    if (length < incident().length)
        m_basis.dropFront(incident(), response);
    else
        incident().length = 0;
    changeBranch(ending, length);
}

template <class Basis>
void ContactMarch<Basis>::changeBranch(Ending ending, Real length) {
    // only within the same piece of the wave: the front of the next piece may raise the force at once
    m_justUnloaded = ending == Ending::unloading && length > 0 && incident().length > 0;
    switch (ending) {
        case Ending::none:
            break;
        case Ending::separation:
            m_force = 0;
            m_gap = 0;
            m_line = ContactLine::apart;
            separate();
            break;
        case Ending::unloading:
            m_law.remember(m_force);
            m_force = std::max(m_force, m_law.largestForce());
            m_line = ContactLine::elastic;
            note(ContactEvent::unloading);
            break;
        case Ending::primaryLoading:
            m_force = m_law.largestForce();
            m_line = ContactLine::primary;
            note(ContactEvent::primaryLoading);
            break;
        case Ending::corner:
            m_law.passCorner();
            m_force = m_law.largestForce();
            m_basis.turnTo(m_law.slope(m_line));
            note(ContactEvent::corner);
            break;
    }
}

}  // namespace drillwave
