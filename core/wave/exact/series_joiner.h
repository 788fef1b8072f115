// SPDX-License-Identifier: GPL-3.0-or-later
// Joins neighbouring wave pieces where one power series follows both: what keeps long contacts affordable.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/power_series.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

// Allowed error of joined wave pieces, from how much work they save.

/// The bounds of joining for one blow, in double precision. A contact with soft rock lasts about 1.6/√(βτ)
/// round trips, or 1.6/√β with small γ, where the front end returns only at every pass of the blow. Each trip
/// leaves its kinks, and every later one passes them: work grows with the square of the trips. From hundreds
/// of trips on, fewer digits of e are required.
struct JoiningBudget {
    double passes = 1;         ///< about how many times a piece of wave meets the rock, ≥ 1
    double smoothEffect = 0;   ///< of one joint on the impulse in all passes, without events in it
    double mostDisplaced = 0;  ///< of the way of the bit by one joint, I0
    double mostDeviation = 0;  ///< of the wave force, F0
    double loadingWeight = 1;  ///< of an impulse displaced before the last peak on that of the rebound

    explicit JoiningBudget(const Problem& problem) {
        const double gamma = problem.law.gamma, tau = problem.transitTime();
        // of the steepest loading line, and of the least steep one
        double beta = problem.law.firstSlope * problem.law.beta, softest = beta;
        for (const LawCorner& corner : problem.law.corners) {
            beta = std::max(beta, corner.slope * problem.law.beta);
            softest = std::min(softest, corner.slope * problem.law.beta);
        }
        const double trips = std::max(1.0, 1.6 / std::sqrt(softest * tau));
        passes =
            std::max(1.0, 1.6 / std::sqrt(softest * std::clamp(100 * gamma * tau, std::min(tau, 1.0), tau)));
        const double excess = std::pow(std::max(1.0, passes / fewPasses), 6);
        const double share = std::min(1.0, leastError / mostError * excess);
        const double error = share * mostError;
        smoothEffect = error / passes;
        // An error D of a peak of the way displaces √(βτ/γ) D while the rod rebounds, D at most. The peaks of
        // all trips displace some sixteen times that, growing with the trips from hundreds on; more where γ
        // is larger, and work no matter.
        const double perDisplacement = std::min(1.0, std::sqrt(beta * tau / gamma));
        const double peaks = std::max(16.0, trips / 12) * std::clamp(2000 * gamma, 1.0, 4.0);
        mostDisplaced = error / (perDisplacement * peaks);
        const double waveForce = std::max(problem.force().peak, 1 / (2 * tau));
        mostDeviation = 1e-9 * std::min(waveForce, std::sqrt(softest / tau)) + 1e-5 * waveForce * share;
        loadingWeight = std::sqrt(gamma);
    }

  private:
    static constexpr double fewPasses = 100;     ///< cheap, whatever each one leaves
    static constexpr double leastError = 1e-15;  ///< of e, for up to so many passes
    static constexpr double mostError = 5e-10;   ///< of e, for any number of passes
};

// Effect of joined wave pieces on the impulse of the rock, through the events that fall into them.

/// Sums up what joining does to e. The force depends on the way of the bit and on the largest one before. The
/// way is displaced inside a joined piece only, by D there; but a peak inside keeps D for ever: until the
/// primary line is reached again the force errs by (β/γ) 2D, at most, and by no more than 2D in impulse after
/// each change, as F follows the wave.
///
/// An impulse displaced before the last peak changes the energy stored there, of which the rod gets the share
/// γ: it counts √γ times. Impulses displaced after it count in full.
template <class Real>
class JoiningError {
  public:
    /// `fastest` is the larger rate of the contact, β/γ.
    void begin(const JoiningBudget& budget, Real fastest) {
        m_fastest = fastest;
        m_loadingWeight = Real(budget.loadingWeight);
        m_loading = m_rebound = m_peak = 0;
    }

    /// `length` of elastic line has passed.
    void passElastic(Real length) { m_rebound += displacedBy(m_peak, length); }

    /// An event in a piece of wave that is displaced by `displaced`, of which `length` is not passed yet.
    void pass(ContactEvent event, Real displaced, Real length) {
        m_rebound += displacedBy(displaced, length);
        if (event == ContactEvent::unloading) m_peak = displaced;
        if (event == ContactEvent::primaryLoading) {
            m_loading += m_rebound;
            m_rebound = 0;
        }
    }

    /// Returns the bound of e, four times the plain sum. Errors are up to half of that sum (tst_joining).
    Real bound() const { return 4 * (m_rebound + m_loadingWeight * m_loading); }

  private:
    /// Returns the impulse displaced by a displaced way of the bit while the force follows it for `length`.
    Real displacedBy(Real way, Real length) const { return 2 * way * std::min(Real(1), m_fastest * length); }

    Real m_fastest = 0;        ///< β/γ
    Real m_loadingWeight = 1;  ///< √γ
    Real m_loading = 0;        ///< impulse displaced before the last return to the primary line, I0
    Real m_rebound = 0;        ///< and since then
    Real m_peak = 0;           ///< displacement of the largest way of the bit, I0
};

// A piece of the wave in the rod, and how far joining it to its neighbours has displaced it.

/// A wave force on a short interval, and what joining may have made of its integral, the way of the bit.
/// Joined pieces keep the impulse of both, so that the way is right before and behind them, and wrong
/// between.
template <class Real>
struct WavePiece : PowerSeries<Real> {
    Real displaced = 0;         ///< about the largest |∫(joined − exact)| up to any place in it, I0
    Real displacedAtStart = 0;  ///< the same at its start: 0 unless it was cut out of a joined piece

    WavePiece() = default;
    WavePiece(const PowerSeries<Real>& exact) : PowerSeries<Real>(exact) {}

    /// Integrals that free flight needs of every piece in every round trip: computed once.
    struct Way {
        Real whole;  ///< ∫ over the length
        Real most;   ///< an upper bound of ∫ over [0, x] for every x up to the length, and 0
        Real size;   ///< ≥ ∫|·|, what the rounding of the first is relative to
    };
    const Way& way() const {
        if (m_hasWay) return m_way;
        m_way = {this->integral(this->length), this->mostIntegral(), this->integralOfSizes()};
        m_hasWay = true;
        return m_way;
    }
    /// To be called when coefficients have been changed from outside.
    void forgetWay() { m_hasWay = false; }

    /// The interval [x, length]: it begins inside what was joined.
    void dropFront(Real x) {
        PowerSeries<Real>::dropFront(x);
        displacedAtStart = displaced;
        forgetWay();
    }
    /// Ends the interval at x.
    void shorten(Real x) {
        if (x == this->length) return;
        this->length = x;
        forgetWay();
    }
    /// Displaced like `other`, from which it is made.
    void displaceLike(const WavePiece& other) {
        displaced = other.displaced;
        displacedAtStart = other.displacedAtStart;
    }
    /// Joined to a piece behind it at the price of `more`. Displacements have either sign, and add up as
    /// such.
    void displace(const WavePiece& next, Real more) {
        const Real before = std::max(displaced, next.displaced);
        displaced = std::sqrt(before * before + more * more);
    }

  private:
    mutable Way m_way{};
    mutable bool m_hasWay = false;
};

/// Every event leaves a kink in the reflected wave, and kinks stay for ever: thousands of round trips would
/// carry thousands of pieces each. Most of these kinks are far too small to matter.
///
/// A joined piece keeps the moments 0 to 3 of both. A contact that passes it without an event then ends as it
/// would have, to the fourth order of aℓ: the rest is counted here. The effect of an event inside it on the
/// displaced way of the bit is counted when it happens (JoiningError).
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
