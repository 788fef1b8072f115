// SPDX-License-Identifier: GPL-3.0-or-later
// Exact solution from event to event at the front end of the rod (theory §3), for any representation of the
// waves. The class is in contact_march_state.h, its steps in contact and in free flight are in the other
// files; this file has its main loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/message.h"
#include "core/wave/exact/contact_march_flight.h"
#include "core/wave/exact/contact_march_steps.h"

namespace drillwave {

template <class Basis>
bool ContactMarch<Basis>::solve(const Problem& problem, Detail detail, Impact& impact,
                                const MarchLimits& limits) {
    m_limits = limits;
    const bool keepsAll = detail == Detail::histories && !limits.handOver;
    m_mostPieces = keepsAll ? std::min(limits.pieces, mostRecordedPieces) : limits.pieces;
    m_nextHandOver = piecesHandedOver;
    m_nextLook = std::min(m_mostPieces, piecesBetweenLooks);
    begin(problem, detail, impact);
    const bool isDecided = march();
    impact.searches = m_basis.searchCount().searches;
    impact.samples = m_basis.searchCount().samples;
    return isDecided;
}

template <class Basis>
bool ContactMarch<Basis>::march() {
    for (;;) {
        if (m_line == ContactLine::apart && incident().length <= 0) {
            if (hammerHasEnded()) {
                if (m_detail < Detail::ledger && m_everTouched && staysAway()) {
                    finish();
                    return true;
                }
                if (flyFree() == Progress::goesOn) continue;
                return !m_basis.failed() || undecided();
            }
            if (m_s >= m_nextProof && staysAway()) {
                finish();
                return true;
            }
        }
        if (incident().length <= 0) nextArrival();
        if (m_line == ContactLine::apart)
            advanceApart();
        else
            advanceContact();
        if (m_basis.failed()) return undecided();
        if (!(m_force >= 0 || m_force < 0)) return fail(translatable("the wave force overflowed"));
        if (isOver()) return true;
    }
}

template <class Basis>
void ContactMarch<Basis>::begin(const Problem& problem, Detail detail, Impact& impact) {
    m_pulse = &problem.force();
    m_impact = &impact;
    m_detail = detail;
    const auto moved = [](double value, int units) {
        return Real(value) * (1 + Real(units) * std::numeric_limits<Real>::epsilon());
    };
    const Real beta = moved(problem.law.beta, m_limits.move.beta);
    m_law = ContactLaw<Real>(problem.law, beta).limitedTo(fastestRate);
    const Real transit = moved(problem.transitTime(), m_limits.move.tau);
    m_roundTrip = 2 * transit;
    m_arrival = problem.force().isRigidBody() ? Real(0) : transit;
    m_s = 0;
    m_hammerTime = 0;
    m_hammerPiece = 0;
    m_everTouched = m_touching = m_justUnloaded = false;
    m_eventsOnTheSpot = 0;
    m_line = ContactLine::apart;
    m_nextProof = never;
    // After the hammer force has ended, free flight closes the gap by 2 in every period. Whole periods of the
    // gap beyond that are counted separately, without rounding.
    const double gap = problem.firstGap();
    const double hammerPeriods = std::ceil(problem.force().end / (2 * problem.transitTime())) + 2;
    const double whole = std::floor(gap);
    m_periodsAhead = Real(std::max(0.0, whole - hammerPeriods));
    m_gap = 2 * (Real(std::min(whole, hammerPeriods)) + Real(gap - whole));
    m_force = 0;
    m_contactTime = 0;
    m_impulse = 0;
    m_error = m_gapError = 0;
    m_growth = 1;
    m_waves.clear();
    incident() = Piece::zero(0);
    m_basis.begin(problem, m_law);
    if (problem.force().isRigidBody())
        m_waves.pushBack(m_basis.constant(m_roundTrip, 1 / m_roundTrip));
    else
        m_waves.pushBack(Piece::zero(m_roundTrip));
    impact.frontArrival = double(m_arrival);
    impact.roundTrip = double(m_roundTrip);
    if (problem.force().isRigidBody())
        impact.hammerWork = double(1 / m_roundTrip);  // ½ m v0²: the rod arrives with it
}

}  // namespace drillwave
