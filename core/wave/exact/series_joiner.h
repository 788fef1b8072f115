// SPDX-License-Identifier: GPL-3.0-or-later
// Joins neighbouring wave pieces where one power series follows both: what keeps long contacts affordable.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/power_series.h"
#include "core/wave/exact/joining_budget.h"
#include "core/wave/exact/wave_piece.h"

namespace drillwave {

/// Every event leaves a kink in the reflected wave, and kinks stay for ever: thousands of round trips would
/// carry thousands of pieces each. Most of these kinks are far too small to matter.
///
/// A joined piece keeps the moments 0 to 3 of both. A contact that passes it without an event then ends as it
/// would have, to the fourth order of aℓ: what is left of that is counted here. What an event inside it makes
/// of the displaced way of the bit is counted when it happens (JoiningError).
template <class Real>
class SeriesJoiner {
  public:
    using Piece = WavePiece<Real>;

    /// `fastest` is the larger rate of the contact, β/γ.
    void begin(const JoiningBudget& budget, Real fastest) {
        const Real precision =
            std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon());
        m_fastest = fastest;
        m_passes = Real(budget.passes);
        m_smoothEffect = Real(budget.smoothEffect) * precision;
        m_mostDisplaced = Real(budget.mostDisplaced) * precision;
        m_mostDeviation = Real(budget.mostDeviation) * precision;
    }

    /// Joins `next` to `last` if that is accurate enough, and adds what it costs without events to `error`.
    bool join(Piece& last, const Piece& next, Real& error) {
        const Real whole = last.length + next.length;
        const Real weight = whole * m_fastest;
        if (weight > Real(layer)) return false;
        const bool forward = last.length >= next.length;  // the longer piece is extended over the shorter
        const Series& longer = forward ? last : next;
        const Series& shorter = forward ? next : last;
        if (shorter.length * jump(last, next) > m_mostDisplaced) return false;
        Series extended = longer;
        extended.dropFront(forward ? last.length : -last.length);
        const Series deviation = difference(shorter, extended);
        if (deviation.magnitude() > m_mostDeviation) return false;
        const Real displaced = displacement(deviation);
        if (displaced > m_mostDisplaced) return false;
        const Real effect = m_passes * displaced * weight * (weight / 3) * (weight / 5) * (weight / 7);
        if (effect > m_smoothEffect) return false;

        Series& joined = m_joined;
        joined = forward ? longer : extended;
        joined.length = whole;
        joined.rescale(whole);
        addMoments(joined, deviation, forward ? last.length / whole : Real(0), shorter.length / whole);
        if (joined.magnitude() > 2 * (last.magnitude() + next.magnitude())) return false;  // would cancel
        static_cast<Series&>(last) = joined;
        last.forgetWay();
        last.displace(next, displaced);
        error += effect;
        return true;
    }

  private:
    using Series = PowerSeries<Real>;

    /// aℓ: a longer piece has a layer of a stiff contact in it, which no other series follows.
    static constexpr double layer = 0.5;

    /// A jump between constants, the commonest reason not to join, seen at once.
    static Real jump(const Piece& last, const Piece& next) {
        return last.count <= 1 && next.count <= 1 ? std::abs(last.startValue() - next.startValue()) : Real(0);
    }

    /// ∫|f| over its length, or somewhat more.
    static Real displacement(const Series& f) {
        Real sum = 0;
        for (int k = 0; k < f.count; ++k) sum += std::abs(f.c[k]) / Real(k + 1);
        return sum * f.length;
    }

    /// f − g on the scale of f's length.
    static Series difference(const Series& f, const Series& g) {
        Series result = f, subtracted = g;
        result.rescale(f.length);
        subtracted.rescale(f.length);
        for (int k = result.count; k < subtracted.count; ++k) result.c[k] = 0;
        result.count = std::max(result.count, subtracted.count);
        for (int k = 0; k < subtracted.count; ++k) result.c[k] -= subtracted.c[k];
        return result;
    }

    Real m_fastest = 0;  ///< β/γ
    Real m_passes = 1;   ///< JoiningBudget
    Real m_smoothEffect = 0;
    Real m_mostDisplaced = 0;
    Real m_mostDeviation = 0;
    Series m_joined;
};

}  // namespace drillwave
