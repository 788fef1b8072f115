// The march from event to event along the front end of the rod (theory §3), for any representation of the
// waves.
#pragma once

#include <cmath>
#include <limits>

#include "core/model/pulse_force.h"
#include "core/model/scenario.h"
#include "core/wave/impact.h"
#include "core/wave/wave_queue.h"

namespace drillwave {

/// Solves  g(s) = Fa(s) + g(s − 2τ) − F(s − 2τ),  F' = a(2g − F),  a = β, β/γ or 0, piece by piece.
///
/// `Basis` represents functions on an interval: it solves one piece of contact exactly, finds first zeros,
/// and cuts and integrates pieces. What it cannot represent it says through Basis::failed().
template <class Basis>
class ContactMarch {
  public:
    using Real = typename Basis::Real;
    using Piece = typename Basis::Piece;

    /// Solves into `impact`. False when the basis cannot represent this blow to full accuracy.
    /// More than `mostPieces` smooth pieces are refused as Outcome::notSolved.
    bool solve(const PulseForce& pulse, const Groups& groups, Detail detail, Impact& impact,
               long mostPieces = defaultMostPieces);

    static constexpr long defaultMostPieces = 30'000'000;

  private:
    enum class Phase {
        apart,    ///< no contact force; a zero gap with nothing arriving is the forceless contact
        primary,  ///< on the primary line, rate β
        elastic,  ///< below the largest force so far, rate β/γ
    };
    enum class Progress { goesOn, finished };

    /// Layers thinner than this are below the rounding of time; taking them so thick moves e by less than
    /// 1e-13.
    static constexpr Real fastestRate = Real(1e15);

    static constexpr std::size_t mostWaiting = 400'000;

    void begin(const PulseForce& pulse, const Groups& groups, Detail detail, Impact& impact);
    bool isSliver(const Piece& piece);
    void nextArrival();
    void advanceApart();
    void advanceContact();
    Progress flyFree();
    Progress skipPeriods(Real momentum);
    void passPeriods(Real periods);
    void closeGap();
    void separate();
    void leave(const Piece& reflected, const Piece& incident, const Piece* force, Real length);
    void finish();
    void summarise();
    void note(ContactEvent kind) {
        if (m_detail != Detail::cor) m_impact->events.push_back({kind, double(m_arrival + m_s)});
    }
    bool fail(const char* reason) {
        m_impact->outcome = Outcome::notSolved;
        m_impact->reason = reason;
        return true;
    }

    Basis m_basis;
    WaveQueue<Piece> m_waves;  ///< g of the next round trip without Fa
    Piece m_incident;          ///< g now arriving
    const PulseForce* m_pulse = nullptr;
    Impact* m_impact = nullptr;
    long m_mostPieces = defaultMostPieces;
    Detail m_detail = Detail::cor;

    Real m_beta = 0, m_unloadingRate = 0, m_roundTrip = 0;
    Real m_arrival = 0;                ///< global time of s = 0
    typename Basis::Sum m_s;           ///< time at the front end
    typename Basis::Sum m_hammerTime;  ///< how far the hammer force has been used
    std::size_t m_hammerPiece = 0;
    bool m_elasticRock = false;
    bool m_everTouched = false;
    bool m_touching = false;  ///< apart, but by zero: forceless contact
    bool m_justUnloaded = false;
    int m_stillEvents = 0;  ///< events in a row without progress in time
    Phase m_phase = Phase::apart;
    Real m_periodsAhead = 0;  ///< periods of free flight still to come before `m_gap` counts
    Real m_gap = 0;           ///< distance still to close, displacement unit I0/Z
    Real m_force = 0;
    Real m_peak = 0;  ///< largest force so far: the memory of the rock
    Real m_contactStart = 0;
    typename Basis::Sum m_impulse;
    Real m_error = 0;
};

template <class Basis>
bool ContactMarch<Basis>::solve(const PulseForce& pulse, const Groups& groups, Detail detail, Impact& impact,
                                long mostPieces) {
    m_mostPieces = mostPieces;
    begin(pulse, groups, detail, impact);
    for (;;) {
        const bool hammerEnded = m_hammerPiece >= m_pulse->segments.size();
        if (m_phase == Phase::apart && hammerEnded && m_incident.length <= 0) {
            if (flyFree() == Progress::finished) return !m_basis.failed();
            continue;
        }
        if (m_incident.length <= 0) nextArrival();
        if (m_phase == Phase::apart)
            advanceApart();
        else
            advanceContact();
        if (m_basis.failed()) return false;
        if (!(m_force >= 0 || m_force < 0)) return fail("the wave force overflowed");
        if (m_impact->pieces > m_mostPieces || m_waves.size() > mostWaiting)
            return fail("more than the permitted number of wave pieces is needed");
    }
}

template <class Basis>
void ContactMarch<Basis>::begin(const PulseForce& pulse, const Groups& groups, Detail detail,
                                Impact& impact) {
    m_pulse = &pulse;
    m_impact = &impact;
    m_detail = detail;
    m_beta = std::min(Real(groups.beta), fastestRate);
    m_unloadingRate = std::min(Real(groups.beta) / Real(groups.gamma), fastestRate);
    m_elasticRock = groups.gamma == 1;
    m_roundTrip = 2 * Real(groups.tau);
    m_arrival = pulse.isRigidBody() ? Real(0) : Real(groups.tau);
    m_s = 0;
    m_hammerTime = 0;
    m_hammerPiece = 0;
    m_everTouched = m_touching = m_justUnloaded = false;
    m_stillEvents = 0;
    m_phase = Phase::apart;
    // Free flight advances by 2 in each period once the hammer has ended: whole periods of the gap beyond
    // that are kept apart, exactly.
    const double hammerPeriods = std::ceil(pulse.end / (2 * groups.tau)) + 2;
    m_periodsAhead = Real(std::max(0.0, std::floor(groups.delta) - hammerPeriods));
    m_gap = pulse.isRigidBody() ? Real(0) : 2 * (Real(groups.delta) - m_periodsAhead);
    m_force = m_peak = m_contactStart = 0;
    m_impulse = 0;
    m_error = 0;
    m_waves.clear();
    m_incident = Piece::zero(0);
    m_basis.begin(pulse, groups);
    if (pulse.isRigidBody())
        m_waves.pushBack(m_basis.constant(m_roundTrip, 1 / m_roundTrip));
    else
        m_waves.pushBack(Piece::zero(m_roundTrip));
    impact.frontArrival = double(m_arrival);
    impact.roundTrip = double(m_roundTrip);
    if (pulse.isRigidBody()) impact.hammerWork = double(1 / m_roundTrip);  // ½ m v0²: the rod arrives with it
}

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

/// The hammer has ended and the ends are free: the incident wave is periodic. Finds the next contact, or the
/// proof that none follows: a whole period without contact and momentum not towards the rock.
template <class Basis>
typename ContactMarch<Basis>::Progress ContactMarch<Basis>::flyFree() {
    Real momentum = 0;
    const std::size_t period = m_waves.size();
    for (std::size_t i = 0; i < period; ++i) {
        Piece& arriving = m_waves.front();
        const auto contact = m_basis.gapClosure(arriving, m_gap);
        if (m_basis.failed()) return Progress::finished;
        if (contact.found) {
            if (m_touching && contact.u > 0) separate();
            m_incident = arriving;
            m_waves.popFront();
            if (contact.u > 0) {
                leave(m_incident, m_incident, nullptr, contact.u);
                m_incident.dropFront(contact.u);
            }
            closeGap();
            return Progress::goesOn;
        }
        const Real impulse = arriving.integral(arriving.length);
        if (m_touching && !arriving.isZero()) separate();
        momentum += impulse;
        if (!m_touching) m_gap -= 2 * impulse;
        ++m_impact->pieces;
        m_s += arriving.length;
        if constexpr (Basis::keepsHistory)
            if (m_detail == Detail::histories) m_basis.record(arriving, nullptr, arriving.length, *m_impact);
        m_waves.rotate();
    }
    return skipPeriods(momentum);
}

/// After one whole period without contact: either it is over, or the rod drifts on and hits again later.
template <class Basis>
typename ContactMarch<Basis>::Progress ContactMarch<Basis>::skipPeriods(Real momentum) {
    if (!m_everTouched) momentum = 1;  // nothing but the hammer has acted
    if (m_periodsAhead > 0) {
        passPeriods(m_periodsAhead);
        m_periodsAhead = 0;
        return Progress::goesOn;
    }
    const Real uncertain = 4 * (m_error + m_basis.momentumNoise());
    if (momentum <= 0 || (m_touching && momentum <= uncertain)) {
        finish();
        if (momentum > -uncertain && !m_touching)
            fail(
                "the momentum after a separation is zero within rounding: whether the rod returns is "
                "undecided");
        return Progress::finished;
    }
    if (momentum <= uncertain) {
        finish();
        fail("the momentum after a separation is zero within rounding: whether the rod returns is undecided");
        return Progress::finished;
    }
    // How far the front end reaches beyond its advance of whole periods, piece by piece: the earliest
    // contact.
    const Real advance = 2 * momentum;
    Real reached = 0, fewest = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < m_waves.size(); ++i) {
        const Piece& piece = m_waves[i];
        const Real most = reached + 2 * m_basis.largestIntegral(piece);
        fewest = std::min(fewest, std::ceil((m_gap - most) / advance));
        reached += 2 * piece.integral(piece.length);
    }
    const Real periods = std::max(fewest - 1, Real(0));  // one less: rounding must not jump past the contact
    if (periods > 0) {
        m_error += periods * (m_everTouched ? uncertain : 0);
        const Real from = m_gap;
        m_gap = std::fma(-periods, advance, m_gap);
        m_error += std::numeric_limits<Real>::epsilon() * (m_everTouched ? from : m_gap);
        passPeriods(periods);
    }
    if (m_impact->pieces > m_mostPieces) {
        fail("more than the permitted number of wave pieces is needed");
        return Progress::finished;
    }
    return Progress::goesOn;
}

template <class Basis>
void ContactMarch<Basis>::passPeriods(Real periods) {
    if (m_detail == Detail::histories)
        m_impact->skips.push_back({double(m_s), double(periods * m_roundTrip)});
    m_s += periods * m_roundTrip;
}

template <class Basis>
void ContactMarch<Basis>::finish() {
    Impact& impact = *m_impact;
    impact.outcome = Outcome::rebounded;
    impact.impulse = double(m_impulse);
    impact.cor = double(m_impulse - 1);
    impact.corError = double(m_error + m_basis.momentumNoise());
    if constexpr (Basis::keepsHistory)
        if (m_detail != Detail::cor) summarise();
}

/// Peak, end and the sums over the last period that balance momentum and energy independently.
template <class Basis>
void ContactMarch<Basis>::summarise() {
    Impact& impact = *m_impact;
    impact.peakForce = double(m_peak);
    if (m_touching) {
        impact.contactDuration += double(m_s - m_contactStart);
        impact.separationTime = double(m_arrival + m_s);
    }
    Real momentum = 0, energy = 0;
    for (std::size_t i = 0; i < m_waves.size(); ++i) {
        const Piece& piece = m_waves[i];
        momentum += piece.integral(piece.length);
        energy += Basis::productIntegral(piece, piece, piece.length);
    }
    impact.finalMomentum = double(momentum);
    impact.finalEnergy = double(energy);
}

}  // namespace drillwave
