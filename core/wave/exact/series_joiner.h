// SPDX-License-Identifier: GPL-3.0-or-later
// Joins neighbouring wave pieces where one power series follows both: what keeps long contacts affordable.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/numeric/power_series.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Every event leaves a kink in the reflected wave, and kinks stay for ever: thousands of round trips would
/// carry thousands of pieces each. Most of these kinks are far too small to matter.
///
/// A joined piece keeps the impulse of both, so that the momentum of the wave is unchanged and only the
/// deviation E over the length ℓ of the shorter, displaced by at most the whole length w, remains. It reaches
/// the impulse of the impact force by at most E ℓ w times the rate at which the force responds, β/γ at most.
template <class Real>
class SeriesJoiner {
  public:
    using Piece = PowerSeries<Real>;

    /// `fastest` is the larger rate of the contact, β/γ.
    void begin(const Problem& problem, Real fastest) {
        m_fastest = fastest;
        m_softForce = Real(std::sqrt(problem.law.beta / problem.transitTime));
        m_relativePeak = Real(std::sqrt(problem.law.beta * problem.transitTime));
        const double trips =
            1.6 / std::sqrt(problem.law.beta * problem.transitTime);  // about those in contact
        const Real precision =
            std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon());
        m_tolerance = Real(mostEffect) * Real(std::max(1.0, trips / manyTrips)) * precision;
        m_mostDeviation = Real(mostDeviation) * precision;
        m_worst = 0;
    }

    /// What joining may have changed in the peak force, relative to it.
    Real peakError() const { return 4 * m_worst * m_relativePeak; }

    /// Joins `next` to `last` if that is accurate enough, and adds what it may cost to `error`.
    bool join(Piece& last, const Piece& next, Real& error) {
        const Real whole = last.length + next.length;
        const Real weight = whole * m_fastest;
        if (weight > Real(layer)) return false;
        const bool forward = last.length >= next.length;  // the longer piece is extended over the shorter
        Piece longer = forward ? last : next;
        Piece shorter = forward ? next : last;
        if (m_tolerance < weight * shorter.length * jump(last, next) / 4) return false;
        Piece extended = longer;
        extended.dropFront(forward ? last.length : -last.length);
        const Piece deviation = difference(shorter, extended);
        const Real size = deviation.magnitude();
        const Real effect = size * shorter.length * weight;
        if (effect > m_tolerance) return false;
        if (size > m_mostDeviation * m_softForce) return false;  // it would move events
        Piece& joined = forward ? longer : extended;
        joined.length = whole;
        joined.rescale(whole);
        if (joined.count == 0) {
            joined.count = 1;
            joined.c[0] = 0;
        }
        joined.c[0] += deviation.integral(shorter.length) / whole;
        if (joined.magnitude() > 2 * (last.magnitude() + next.magnitude())) return false;  // would cancel
        last = joined;
        error += effect;
        m_worst = std::max(m_worst, size * shorter.length);
        return true;
    }

  private:
    /// Of one joint on the impulse of order one, in double precision: a twentieth of its rounding.
    static constexpr double mostEffect = 1e-17;
    /// From so many round trips in contact on each joint may err in proportion: kinks are as many as trips.
    static constexpr double manyTrips = 100;
    /// Of the wave relative to the force on soft rock: more would move events, which the effect on the
    /// impulse of a single joint does not show.
    static constexpr double mostDeviation = 1e-9;
    /// aℓ: a longer piece has a layer of a stiff contact in it, which no other series follows.
    static constexpr double layer = 0.5;

    /// A jump between constants, the commonest reason not to join, seen at once.
    static Real jump(const Piece& last, const Piece& next) {
        return last.count <= 1 && next.count <= 1 ? std::abs(last.startValue() - next.startValue()) : Real(0);
    }

    /// f − g on the scale of f's length.
    static Piece difference(const Piece& f, const Piece& g) {
        Piece result = f, subtracted = g;
        result.rescale(f.length);
        subtracted.rescale(f.length);
        for (int k = result.count; k < subtracted.count; ++k) result.c[k] = 0;
        result.count = std::max(result.count, subtracted.count);
        for (int k = 0; k < subtracted.count; ++k) result.c[k] -= subtracted.c[k];
        return result;
    }

    Real m_fastest = 0;        ///< β/γ
    Real m_softForce = 0;      ///< √(β/τ), about the peak force on a soft rock
    Real m_relativePeak = 0;   ///< √(βτ), about β over that force
    Real m_tolerance = 0;      ///< of the effect on the impulse
    Real m_mostDeviation = 0;  ///< of the wave force where the contact is soft, relative to m_softForce
    Real m_worst = 0;          ///< largest impulse displaced: the peak force errs by β times it
};

}  // namespace drillwave
