// SPDX-License-Identifier: GPL-3.0-or-later
// Lattice method: computation of a blow in time steps at the front end of the rod (paper, Appendix A).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stop_token>

#include "core/contact/step_law.h"
#include "core/model/pulse_force.h"
#include "core/model/scenario.h"
#include "core/numeric/compensated_sum.h"
#include "core/text/message.h"
#include "core/text/units.h"
#include "core/wave/impact.h"
#include "core/wave/lattice/hammer_cells.h"
#include "core/wave/problem.h"

namespace drillwave {

// Histories that are constant in each time step

/// Recorder of incident wave and impact force at the bit: appends one time step of the lattice after the
/// other to the histories of an impact. Successive steps with equal values become one polynomial piece.
class StepHistory {
  public:
    /// Starts a recording of the histories with the time step `step`, in units of t0.
    void begin(double step) {
        m_step = step;
        m_count = 0;
        m_pieces = 0;
    }

    /// Adds a time step with the incident wave g and the impact force F, both in units of F0.
    void add(double g, double force, Impact& impact) {
        if (m_count > 0 && (g != m_incident || force != m_force)) flush(impact);
        m_incident = g;
        m_force = force;
        ++m_count;
    }
    /// Appends the equal time steps counted so far to the histories of the impact, as one polynomial piece.
    void flush(Impact& impact) {
        if (m_count == 0) return;
        const double length = double(m_count) * m_step;
        impact.incident.append(length, length, coefficients(m_incident));
        impact.force.append(length, length, coefficients(m_force));
        ++m_pieces;
        m_count = 0;
    }
    /// Returns the number of polynomial pieces appended to the histories so far. Each piece is a constant
    /// value over one or more time steps.
    std::size_t pieces() const { return m_pieces; }

  private:
    static std::span<const double> coefficients(const double& value) {
        return {&value, value == 0 ? 0U : 1U};
    }

    double m_step = 1;
    double m_incident = 0, m_force = 0;
    long m_count = 0;
    std::size_t m_pieces = 0;
};

/// Solver for one blow by the lattice method. `Waves` is the class that stores the waves in the segments:
/// MovedWaves or RingWaves.
template <class Waves>
class LatticeMarch {
  public:
    /// Computes a blow on a rod of `segments` equal segments, and writes the result into `impact`, except its
    /// corError.
    void solve(const Problem& problem, int segments, Detail detail, const std::stop_token& stop,
               Impact& impact);

    /// Returns an estimate of the rounding error of the impulse in the last solution, in units of I0.
    double roundingError() const { return roundingAfter(m_step); }

  private:
    // Limits for about one second of work with the ring buffer and twenty with moved waves, and for 200 MB of
    // histories.
    static constexpr double mostSteps = 1e8;
    static constexpr double mostMoves = 1e11;
    static constexpr std::size_t mostRecorded = 2'000'000;
    /// Number of moves of a wave from one segment to the next between two checks for a stop request.
    static constexpr long movesPerCheck = 1L << 20;
    /// Impulse [I0] up to which a contact shorter than a time step is ignored, because rounding can cause it.
    /// A larger impulse makes the blow unsolved.
    static constexpr double negligibleImpulse = 1e-12;

    void begin(const Problem& problem, int segments, Detail detail, Impact& impact);
    bool isFeasible(const Problem& problem, int segments);
    void reachFrontEnd(int segments, const std::stop_token& stop);
    void step();
    void noteChanges(double impulseBefore);
    void flyFree(double g);
    void decide();
    void skipPeriods(double momentum);
    void finish();
    void countWork(const std::stop_token& stop);
    void fail(Message reason) {
        m_impact->outcome = Outcome::notSolved;
        m_impact->reason = std::move(reason);
        m_over = true;
    }
    void note(ContactEvent kind, double time) {
        if (m_detail != Detail::cor) m_impact->events.push_back({kind, time});
    }
    /// Returns the time t/t0 since the start of the blow at a `fraction` of the last time step: 0 is its
    /// start, 1 its end.
    double timeAt(double fraction) const {
        return m_arrival + m_skipped + (double(m_step - 1) + fraction) * m_duration;
    }
    static double roundingAfter(long steps) {
        return 8 * std::numeric_limits<double>::epsilon() * (1 + std::sqrt(double(steps)));
    }
    double impulse() const { return m_forces * m_duration; }

    Waves m_waves;
    HammerCells m_hammer;  ///< hammer force as it arrives at the front end
    StepLaw m_law{ContactLaw<>(1, 1), 1, 0, 0};
    StepHistory m_history;
    Impact* m_impact = nullptr;
    Detail m_detail = Detail::cor;
    bool m_over = false;

    double m_duration = 1;    ///< time step Δ, in units of t0
    double m_arrival = 0;     ///< time t/t0 at which the first wave reaches the bit (s = 0)
    double m_skipped = 0;     ///< total duration of the periods left out, in units of t0
    double m_negligible = 0;  ///< force that has no effect on the result, in units of F0
    long m_step = 0;          ///< number of steps since the first wave arrived
    long m_period = 0;        ///< number of steps in a round trip, 2L
    long m_movesPerStep = 1, m_untilCheck = 0;
    double m_moves = 0;

    /// Sum ΣF of the impact force over the time steps; times Δ it is the impulse on the rock.
    CompensatedSum<double> m_forces;
    /// Sums ΣFa (2g − Fa) and ΣF (2g − F) over the time steps. Multiplied by Δ, they are the work of the
    /// hammer and the work on the rock.
    CompensatedSum<double> m_hammerPowers, m_rockPowers;
    double m_contactStart = 0, m_impulseAtContact = 0;
    /// Number of whole round trips of free flight that still pass before the bit can reach the rock.
    double m_periodsAhead = 0;

    /// Number of successive steps with neither contact nor hammer force.
    long m_freeSteps = 0;
    double m_freeMomentum = 0, m_freeEnergy = 0;
    /// Largest sum Σg of the incident wave over the time steps since the free flight began. Multiplied by 2Δ
    /// it is the largest displacement of the front end towards the rock in this flight, in units of I0/Z.
    double m_farthest = 0;
};

template <class Waves>
void LatticeMarch<Waves>::solve(const Problem& problem, int segments, Detail detail,
                                const std::stop_token& stop, Impact& impact) {
    begin(problem, segments, detail, impact);
    if (!isFeasible(problem, segments)) return;
    if (!problem.force().isRigidBody()) reachFrontEnd(segments, stop);
    while (!m_over) {
        step();
        countWork(stop);
    }
    impact.pieces = m_step;
    if (detail == Detail::histories && impact.outcome == Outcome::rebounded) m_history.flush(impact);
}

template <class Waves>
void LatticeMarch<Waves>::begin(const Problem& problem, int segments, Detail detail, Impact& impact) {
    const bool isRigidBody = problem.force().isRigidBody();
    const double uniform = isRigidBody ? 1 / (2 * problem.transitTime()) : 0;
    m_impact = &impact;
    m_detail = detail;
    m_over = false;
    m_duration = problem.transitTime() / segments;
    m_arrival = isRigidBody ? 0 : problem.transitTime();
    m_skipped = 0;
    m_negligible = std::ldexp(std::max(problem.force().peak, 1 / (2 * problem.transitTime())), -62);
    m_step = 0;
    m_period = 2L * segments;
    m_movesPerStep = Waves::movesPerStep(segments);
    m_untilCheck = 0;
    m_moves = 0;
    m_forces = m_hammerPowers = m_rockPowers = 0;
    m_contactStart = m_impulseAtContact = 0;
    m_freeSteps = 0;
    m_freeMomentum = m_freeEnergy = m_farthest = 0;
    // Once the hammer force has ended, free flight closes the gap by 2 in each round trip. Whole round trips
    // of the gap beyond that are counted separately, without rounding.
    const double hammerPeriods = std::ceil(problem.force().end / (2 * problem.transitTime())) + 2;
    m_periodsAhead = std::max(0.0, std::floor(problem.gap) - hammerPeriods);
    const double gap = isRigidBody ? 0 : 2 * (problem.gap - m_periodsAhead);
    m_law = StepLaw(ContactLaw<>(problem.law), m_duration, gap, m_negligible);
    m_hammer = HammerCells(problem.force(), m_duration);
    m_history.begin(m_duration);
    impact.frontArrival = m_arrival;
    impact.roundTrip = 2 * problem.transitTime();
    impact.hammerWork = uniform;  // ½ m v0²: the rod arrives with it
}

/// Returns whether the time step is short enough for the stiffness of the rock, and whether the hammer force
/// lasts no more steps than permitted. If so, the waves are prepared; otherwise the blow is marked as not
/// solved.
template <class Waves>
bool LatticeMarch<Waves>::isFeasible(const Problem& problem, int segments) {
    const double steepest = ContactLaw<>(problem.law).slopes().elastic * m_duration;
    if (!(steepest <= 2)) {
        const double least =
            std::ceil(ContactLaw<>(problem.law).slopes().elastic * problem.transitTime() / 2);
        fail({translatable("a step of the lattice is too long for the rock: (beta/gamma) tau/N = %1 must not "
                           "exceed 2; it takes at least %2 segments"),
              {formatNumber(steepest), formatNumber(least)}});
        return false;
    }
    if (!(problem.force().end / m_duration + double(m_period) < mostSteps)) {
        fail({translatable("the lattice would need more than the permitted number of steps; use fewer than "
                           "%1 segments, or the exact method"),
              {formatNumber(segments)}});
        return false;
    }
    m_waves.begin(segments, problem.force().isRigidBody() ? 1 / (2 * problem.transitTime()) : 0,
                  problem.force(), m_duration);
    return true;
}

/// Advances the waves until the first one reaches the front end of the rod. Until then, bit and rock need not
/// be computed.
template <class Waves>
void LatticeMarch<Waves>::reachFrontEnd(int segments, const std::stop_token& stop) {
    for (long ahead = Waves::stepsAhead(segments); ahead > 0 && !m_over; --ahead) {
        m_waves.step(0);
        countWork(stop);
    }
}

template <class Waves>
void LatticeMarch<Waves>::step() {
    const double hammer = m_hammer.next();
    const double g = m_waves.arriving(hammer);
    const double force = m_law.advance(g);
    const double reflected = force - g;
    m_waves.step(std::abs(reflected) > m_negligible ? reflected : 0);
    ++m_step;

    const double impulseBefore = impulse();
    m_forces += force;
    if (m_detail != Detail::cor) {
        m_hammerPowers += hammer * (2 * g - hammer);
        m_rockPowers += force * (2 * g - force);
        if (m_detail == Detail::histories) m_history.add(g, force, *m_impact);
    }
    if (m_law.changes() != StepLaw::none) noteChanges(impulseBefore);
    if (force == 0 && m_law.changes() == StepLaw::none && m_hammer.ended() && (m_law.isApart() || g == 0))
        flyFree(g);
    else
        m_freeSteps = 0;
}

template <class Waves>
void LatticeMarch<Waves>::noteChanges(double impulseBefore) {
    const unsigned changes = m_law.changes();
    if (changes & StepLaw::contact) {
        m_contactStart = timeAt(m_law.contactFraction());
        m_impulseAtContact = impulseBefore;
        if (m_impact->contacts++ == 0) m_impact->firstContactTime = m_contactStart;
        note(ContactEvent::contact, m_contactStart);
    }
    if (changes & StepLaw::unloading) note(ContactEvent::unloading, timeAt(0));
    if (changes & StepLaw::primaryLoading)
        note(ContactEvent::primaryLoading, timeAt(m_law.primaryFraction()));
    if (changes & StepLaw::corner)
        for (const double fraction : m_law.cornerFractions()) note(ContactEvent::corner, timeAt(fraction));
    if (changes & StepLaw::separation) {
        const double time = timeAt(m_law.separationFraction());
        m_impact->contactDuration += time - m_contactStart;
        m_impact->separationTime = time;
        note(ContactEvent::separation, time);
        const double exchanged = impulse() - m_impulseAtContact;
        if (time - m_contactStart < m_duration && exchanged > negligibleImpulse)
            fail({translatable("a contact at time %1 is shorter than a step of the lattice; use more "
                               "segments or the exact method"),
                  {formatNumber(m_contactStart)}});
    }
}

/// Counts a time step without hammer force and without contact of bit and rock. After a whole round trip of
/// such steps it decides whether the blow is over.
template <class Waves>
void LatticeMarch<Waves>::flyFree(double g) {
    if (m_freeSteps++ == 0) m_freeMomentum = m_freeEnergy = m_farthest = 0;
    m_freeMomentum += g;
    m_freeEnergy += g * g;
    m_farthest = std::max(m_farthest, m_freeMomentum);
    if (m_freeSteps < m_period) return;
    decide();
    m_freeSteps = 0;
}

/// Decides how to continue after a whole round trip without contact and hammer force, when the incident wave
/// repeats. Either the blow is over, or the rod drifts towards the rock and hits it again later (theory
/// §3.3).
template <class Waves>
void LatticeMarch<Waves>::decide() {
    if (m_periodsAhead > 0) {
        m_impact->skips.push_back({timeAt(1) - m_arrival, m_periodsAhead * m_impact->roundTrip});
        m_skipped += m_periodsAhead * m_impact->roundTrip;
        m_periodsAhead = 0;
        return;
    }
    const double momentum = m_freeMomentum * m_duration;
    const double uncertain = 4 * roundingError();
    const bool touches = !m_law.isApart();
    if (momentum > uncertain) return skipPeriods(momentum);
    finish();
    if (!touches && momentum > -uncertain)
        fail(
            translatable("the momentum after a separation is zero within rounding: it cannot be decided "
                         "whether the rod returns"));
}

template <class Waves>
void LatticeMarch<Waves>::skipPeriods(double momentum) {
    const double advance = 2 * momentum;
    const double reached = 2 * m_farthest * m_duration;
    // one less: rounding must not jump past the contact
    const double periods = std::ceil((m_law.gap() - reached) / advance) - 1;
    if (!(periods > 0)) return;
    m_law.setGap(std::fma(-periods, advance, m_law.gap()));
    m_impact->skips.push_back({timeAt(1) - m_arrival, periods * m_impact->roundTrip});
    m_skipped += periods * m_impact->roundTrip;
}

template <class Waves>
void LatticeMarch<Waves>::finish() {
    Impact& impact = *m_impact;
    m_over = true;
    impact.outcome = Outcome::rebounded;
    impact.impulse = impulse();
    impact.cor = impact.impulse - 1;  // [paper (10)]
    if (m_detail == Detail::cor) return;
    impact.peakForce = m_law.peak();
    if (!m_law.isApart() && impact.contacts > 0) {
        impact.contactDuration += timeAt(1) - m_contactStart;
        impact.separationTime = timeAt(1);
    }
    impact.hammerWork += m_hammerPowers * m_duration;
    impact.rockWork = m_rockPowers * m_duration;
    impact.finalMomentum = m_freeMomentum * m_duration;
    impact.finalEnergy = m_freeEnergy * m_duration;
}

template <class Waves>
void LatticeMarch<Waves>::countWork(const std::stop_token& stop) {
    if (m_over || --m_untilCheck > 0) return;
    m_untilCheck = std::max(1L, movesPerCheck / m_movesPerStep);
    m_moves += double(m_untilCheck) * double(m_movesPerStep);
    if (stop.stop_requested()) return fail("stopped");
    const bool atMemory = m_history.pieces() > mostRecorded;
    if (double(m_step) > mostSteps || m_moves > mostMoves || atMemory) {
        fail(translatable(
            "the lattice needs more than the permitted number of steps; use fewer segments or the exact "
            "method"));
        if (atMemory) m_impact->hindrance = Hindrance::histories;
    }
    if (m_impact->events.size() > mostRecorded)
        fail(
            translatable("the lattice found more than the permitted number of events; use the exact method"));
}

}  // namespace drillwave
