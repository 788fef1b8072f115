// SPDX-License-Identifier: GPL-3.0-or-later
// Free flight of ContactMarch between contacts, and the end of the solution. Included by contact_march.h
// only.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/message.h"
#include "core/wave/exact/contact_march_state.h"

namespace drillwave {

/// Returns whether it is proven that bit and rock cannot touch again, even if the hammer still pushes. In
/// each round trip of a wave, the front end moves by twice the momentum of the rod. The hammer adds at most
/// the rest of its impulse to that momentum. Within a round trip, the front end moves no further than the
/// waves in the rod and this rest can push it.
template <class Basis>
bool ContactMarch<Basis>::staysAway() {
    m_nextProof = m_s + m_roundTrip;
    constexpr Real impulseOfHammer = Real(1e-12);  // rounding of the impulse of 100 000 segments
    const Real uncertain = uncertainMomentum() + impulseOfHammer;
    const Real momentum = 1 - m_impulse;  // after the end of the hammer force
    if (m_touching || m_periodsAhead > 0 || momentum > -uncertain) return false;
    const Real rest = hammerHasEnded() ? Real(0) : 1 - Real(m_pulse->segments[m_hammerPiece].impulseBefore);
    const Real free = m_gap / 2 - rest - uncertain;
    if (free <= 0) return false;
    constexpr std::size_t manyPieces = 16;  // to compute more than these costs more than the bound
    const bool isLong = !hammerHasEnded() && m_waves.size() > manyPieces;
    Real reached = 0;
    for (std::size_t i = 0; i < m_waves.size(); ++i) {
        const Piece& piece = m_waves[i];
        const Real impulse = m_basis.impulse(piece);
        if (reached + m_basis.mostIntegral(piece, impulse, free - reached) > free) {
            if (!isLong || reached + m_basis.largestIntegral(piece) > free) return false;
        }
        reached += impulse;
    }
    return !m_basis.failed();
}

/// Follows the free flight over one period (round trip) after the end of the hammer force, when both ends are
/// free and the incident wave repeats. It ends at the next contact, or with the proof that none follows. The
/// proof is a period without contact and with momentum not towards the rock (T21).
template <class Basis>
typename ContactMarch<Basis>::Progress ContactMarch<Basis>::flyFree() {
    Real momentum = 0;
    const std::size_t period = m_waves.size();
    for (std::size_t i = 0; i < period; ++i) {
        const Piece& arriving = m_waves[i];
        const auto contact = m_basis.gapClosure(arriving, m_gap);
        if (m_basis.failed()) return Progress::finished;
        if (contact.found) {
            if (m_touching && contact.u > 0) separate();
            m_waves.rotate(i);
            m_waves.take();
            if (contact.u > 0) leaveFree(contact.u);
            closeGap(incident(), contact.u);
            if (contact.u > 0) incident().dropFront(contact.u);
            return Progress::goesOn;
        }
        const Real impulse = m_basis.impulse(arriving);
        if (m_touching && !arriving.isZero()) separate();
        momentum += impulse;
        if (!m_touching) drift(arriving, impulse);
        pass(arriving, nullptr, arriving.length);
    }
    return skipPeriods(momentum);
}

/// Decides how to continue after a whole round trip without contact: either the blow is over, or the rod
/// drifts towards the rock and hits it again later. In the second case whole round trips are skipped.
template <class Basis>
typename ContactMarch<Basis>::Progress ContactMarch<Basis>::skipPeriods(Real momentum) {
    if (!m_everTouched) momentum = 1;  // only the hammer has acted
    if (m_periodsAhead > 0) {
        passPeriods(m_periodsAhead);
        m_periodsAhead = 0;
        return Progress::goesOn;
    }
    const Real uncertain = uncertainMomentum();
    if (momentum <= uncertain) {
        finish();
        // It is undecided whether a rod with almost no momentum returns. If it did, the impulse of that
        // contact would be as small as the uncertainty, so it is added to the error.
        if (momentum > -uncertain && !m_touching) m_impact->corError += double(2 * uncertain);
        return Progress::finished;
    }
    // `reached` is the displacement of the front end within a period, beyond its advance of whole periods. It
    // bounds the earliest contact.
    const Real advance = 2 * momentum;
    Real reached = 0, fewest = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < m_waves.size(); ++i) {
        const Piece& piece = m_waves[i];
        const Real most = reached + 2 * m_basis.largestIntegral(piece);
        fewest = std::min(fewest, std::ceil((m_gap - most) / advance));
        reached += 2 * m_basis.impulse(piece);
    }
    const Real periods = std::max(fewest - 1, Real(0));  // one less: rounding must not jump past the contact
    if (periods > 0) {
        m_error += periods * (m_everTouched ? uncertain : 0);
        const Real from = m_gap;
        m_gap = std::fma(-periods, advance, from);
        m_error += std::numeric_limits<Real>::epsilon() * (m_everTouched ? from : Real(m_gap));
        passPeriods(periods);
    }
    return isOver() ? Progress::finished : Progress::goesOn;
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
    impact.cor = double(m_impulse - 1);  // [paper (10)]
    impact.corError = double(m_error + m_basis.momentumNoise());
    impact.growth = double(m_growth);
    if (m_detail != Detail::cor) summarise();
}

/// Computes peak force, contact duration and work on the rock of a solved blow. With Detail::ledger, it also
/// sums momentum and energy of the waves that remain in the rod. If the energies then do not balance, the
/// blow is marked as not solved.
template <class Basis>
void ContactMarch<Basis>::summarise() {
    Impact& impact = *m_impact;
    impact.peakForce = double(m_law.largestForce());
    impact.contactDuration = double(m_contactTime);
    if (m_touching) impact.separationTime = double(m_arrival + m_s);
    impact.rockWork = double(m_law.kept());
    if (m_detail < Detail::ledger || !m_limits.ledger) {
        impact.finalMomentum = impact.finalEnergy = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    Real momentum = 0, energy = 0;
    for (std::size_t i = 0; i < m_waves.size(); ++i) {
        const Piece& piece = m_waves[i];
        momentum += m_basis.impulse(piece);
        energy += m_basis.productIntegral(piece, piece, piece.length);
    }
    impact.finalMomentum = double(momentum);
    impact.finalEnergy = double(energy);
    if (!(std::abs(impact.energyResidual()) <= mostMissingEnergy))
        fail(translatable("its energies do not balance, so that its numbers are wrong"));
}

}  // namespace drillwave
