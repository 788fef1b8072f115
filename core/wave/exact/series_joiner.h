// SPDX-License-Identifier: GPL-3.0-or-later
// Joining of neighbouring pieces of a wave if one power series follows both, which keeps long contacts
// affordable.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/power_series.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

// Permitted error of joined pieces of waves, which depends on the work that they save

/// Limits of the errors that joining neighbouring pieces of a wave may cause in one blow, in double
/// precision. Each contact event leaves a kink in the wave, where a new piece begins, and all earlier kinks
/// arrive again in each round trip. The work therefore grows with the square of the number of round trips. A
/// contact with soft rock lasts about 1.6/√(βτ) round trips. With small γ it lasts 1.6/√β, because the front
/// end moves back only while the wave of the blow passes. From hundreds of round trips on, fewer digits of
/// the coefficient of restitution e are required.
struct JoiningBudget {
    /// Approximate number of times that a piece of the wave meets the rock; ≥ 1.
    double passes = 1;
    /// Largest permitted effect of joining two pieces of the wave once, on the impulse over all passes, in
    /// units of I0. It applies while no contact event occurs in the joined piece.
    double smoothEffect = 0;
    /// Largest permitted error of the bit's position due to joining two pieces of the wave, in units of I0/Z.
    double mostDisplaced = 0;
    /// Largest permitted change of the wave force by joining two pieces of the wave, in units of F0.
    double mostDeviation = 0;
    /// Weight √γ of an impulse error during loading, relative to an error after the last force peak; 0 … 1.
    double loadingWeight = 1;

    explicit JoiningBudget(const Problem& problem) {
        const double gamma = problem.law.gamma, tau = problem.transitTime();
        // slopes of the steepest and of the least steep loading line
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
        // An error D of the largest penetration in one round trip changes e by √(βτ/γ) D during the rebound,
        // at most by D. All round trips together have about sixteen times this effect, and more from hundreds
        // of trips on. A larger γ needs a larger margin; work is no concern there.
        const double perDisplacement = std::min(1.0, std::sqrt(beta * tau / gamma));
        const double peaks = std::max(16.0, trips / 12) * std::clamp(2000 * gamma, 1.0, 4.0);
        mostDisplaced = error / (perDisplacement * peaks);
        const double waveForce = std::max(problem.force().peak, 1 / (2 * tau));
        mostDeviation = 1e-9 * std::min(waveForce, std::sqrt(softest / tau)) + 1e-5 * waveForce * share;
        loadingWeight = std::sqrt(gamma);
    }

  private:
    /// Number of times the wave may meet the rock in one blow that takes little work even if no pieces are
    /// joined.
    static constexpr double fewPasses = 100;
    /// Permitted error of the coefficient of restitution if the wave meets the rock at most fewPasses times.
    static constexpr double leastError = 1e-15;
    /// Largest permitted error of the coefficient of restitution, however often the wave meets the rock.
    static constexpr double mostError = 5e-10;
};

// Effect of joined pieces on the impulse of the rock, through events inside them

/// Sum of the errors of the coefficient of restitution that joining pieces of the wave causes. The impact
/// force depends on the position of the bit, and on its largest penetration so far. Joining makes the
/// position wrong by D, but only inside a joined piece. If the force has a peak there, the error of that peak
/// remains. Until the force returns to the loading curve, it is wrong by at most (β/γ) 2D. Each change
/// contributes at most 2D to the impulse, since F follows the wave.
///
/// An impulse error before the last peak changes the energy stored there, of which the rod receives the share
/// γ. So it counts √γ times; errors after the peak count in full.
template <class Real>
class JoiningError {
  public:
    /// Resets the error for a new blow. `fastest` is the larger rate of the contact, β/γ [1/t0].
    void begin(const JoiningBudget& budget, Real fastest) {
        m_fastest = fastest;
        m_loadingWeight = Real(budget.loadingWeight);
        m_loading = m_rebound = m_peak = 0;
    }

    /// Adds the error of the rock's impulse for a contact that stays on the elastic line (unloading or
    /// reloading) for `length` [t0].
    void passElastic(Real length) { m_rebound += displacedBy(m_peak, length); }

    /// Adds the error of a contact event within a piece of the wave that was joined from several. `displaced`
    /// is the error of the bit's position there due to joining, in units of I0/Z. `length` is the length of
    /// the piece that was still to arrive when the stretch of contact began, in units of t0.
    void pass(ContactEvent event, Real displaced, Real length) {
        m_rebound += displacedBy(displaced, length);
        if (event == ContactEvent::unloading) m_peak = displaced;
        if (event == ContactEvent::primaryLoading) {
            m_loading += m_rebound;
            m_rebound = 0;
        }
    }

    /// Returns an upper bound of the error of the coefficient of restitution due to joined pieces: four times
    /// the sum of the estimated errors. Actual errors are up to half of that sum (tst_joining).
    Real bound() const { return 4 * (m_rebound + m_loadingWeight * m_loading); }

  private:
    /// Returns the error of the rock's impulse [I0] if the bit's position is wrong by `way` [I0/Z] for the
    /// time `length` [t0].
    Real displacedBy(Real way, Real length) const { return 2 * way * std::min(Real(1), m_fastest * length); }

    Real m_fastest = 0;        ///< larger rate β/γ of the contact, per t0
    Real m_loadingWeight = 1;  ///< weight √γ of impulse errors before the last force peak
    /// Error of the rock's impulse due to joined pieces of the wave, in units of I0. It counts up to the last
    /// return of the force to the loading curve of the bit–rock law.
    Real m_loading = 0;
    /// Error of the rock's impulse due to joined pieces of the wave, in units of I0. It counts from the last
    /// return of the force to the loading curve of the bit–rock law.
    Real m_rebound = 0;
    /// Error of the bit's largest penetration due to joined pieces of the wave, in units of I0/Z.
    Real m_peak = 0;
};

// Piece of the wave in the rod, with the error of the bit's path by joining it to neighbours

/// Wave force on a short interval as a power series, possibly joined from several pieces. A joined piece
/// keeps their total impulse. The bit's position, which follows from it, is therefore correct at both ends
/// and slightly wrong between.
template <class Real>
struct WavePiece : PowerSeries<Real> {
    /// Approximate largest error of the bit's position within this piece due to joining, |∫(joined − exact)|,
    /// in units of I0; 0 if the piece was not joined.
    Real displaced = 0;
    /// Error of the bit's position at the start of the piece, in units of I0; 0 unless the piece was cut out
    /// of a joined one.
    Real displacedAtStart = 0;

    WavePiece() = default;
    WavePiece(const PowerSeries<Real>& exact) : PowerSeries<Real>(exact) {}

    /// Integrals of the wave over a piece, which free flight needs in every round trip; computed only once.
    struct Way {
        /// Integral of the wave over the whole length of the piece, in units of I0.
        Real whole;
        /// Upper bound, at least 0, of the integral of the wave over [0, x] for every x up to the length, in
        /// units of I0.
        Real most;
        /// Upper bound of ∫|f| over the piece for its wave force f, in units of I0. Times the machine
        /// epsilon, it estimates the rounding error of `whole`, the integral ∫f.
        Real size;
    };
    /// Returns the integrals of the wave over this piece, which are computed at the first call only.
    const Way& way() const {
        if (m_hasWay) return m_way;
        m_way = {this->integral(this->length), this->mostIntegral(), this->integralOfSizes()};
        m_hasWay = true;
        return m_way;
    }
    /// Discards the stored integrals; must be called when coefficients were changed from outside.
    void forgetWay() { m_hasWay = false; }

    /// Removes the part of the piece before x [t0]. In a joined piece, the position of the bit may then be
    /// wrong already at the new start.
    void dropFront(Real x) {
        PowerSeries<Real>::dropFront(x);
        displacedAtStart = displaced;
        forgetWay();
    }
    /// Shortens the piece of the wave to [0, x], in units of t0 from its start.
    void shorten(Real x) {
        if (x == this->length) return;
        this->length = x;
        forgetWay();
    }
    /// Copies the errors of the bit's position, `displaced` and `displacedAtStart`, from the piece `other`,
    /// from which this piece was computed.
    void displaceLike(const WavePiece& other) {
        displaced = other.displaced;
        displacedAtStart = other.displacedAtStart;
    }
    /// Updates `displaced` when this piece is joined to `next`. `more` is the error of the bit's position due
    /// to this joining, in the same unit. The result is √(D² + more²), where D is the larger `displaced` of
    /// the two, since such errors have either sign.
    void displace(const WavePiece& next, Real more) {
        const Real before = std::max(displaced, next.displaced);
        displaced = std::sqrt(before * before + more * more);
    }

  private:
    mutable Way m_way{};
    mutable bool m_hasWay = false;
};

/// Joining of neighbouring pieces of the wave in the rod into one, to save work. Every contact event leaves a
/// kink in the reflected wave, where one piece ends and the next begins. Kinks never vanish, and after
/// thousands of round trips there would be thousands of pieces. Most of the kinks are far too small to
/// matter.
///
/// A joined piece keeps the moments 0 to 3 of both pieces. A contact without an event in it then ends almost
/// as before; join() reports the error. Events inside a joined piece happen at a slightly wrong position of
/// the bit. JoiningError adds their effect.
template <class Real>
class SeriesJoiner {
  public:
    using Piece = WavePiece<Real>;

    /// Prepares the joining of pieces for a new blow. `fastest` is the larger rate of the contact, β/γ
    /// [1/t0].
    void begin(const JoiningBudget& budget, Real fastest) {
        const Real precision =
            std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon());
        m_fastest = fastest;
        m_passes = Real(budget.passes);
        m_smoothEffect = Real(budget.smoothEffect) * precision;
        m_mostDisplaced = Real(budget.mostDisplaced) * precision;
        m_mostDeviation = Real(budget.mostDeviation) * precision;
    }

    /// Replaces two neighbouring pieces of the wave by one power series in `last`, if that is accurate
    /// enough. Otherwise returns false and changes nothing. The error of the coefficient of restitution is
    /// added to `error`. It does not include the effect of contact events within the new piece (see
    /// JoiningError).
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

    /// Largest product aℓ of contact rate a and length ℓ for a joined piece of the wave. In a longer piece,
    /// the force of a stiff contact could change too fast for one power series.
    static constexpr double layer = 0.5;

    /// Returns the jump of the wave force between two neighbouring constant pieces, in units of F0; 0 if a
    /// piece is not constant. A jump is the most frequent reason not to join pieces, and it is quickly
    /// computed.
    static Real jump(const Piece& last, const Piece& next) {
        return last.count <= 1 && next.count <= 1 ? std::abs(last.startValue() - next.startValue()) : Real(0);
    }

    /// Returns ∫|f| over the length of f, or a slightly larger value. It is the error of the bit's position,
    /// in units of I0, if the wave has the error f.
    static Real displacement(const Series& f) {
        Real sum = 0;
        for (int k = 0; k < f.count; ++k) sum += std::abs(f.c[k]) / Real(k + 1);
        return sum * f.length;
    }

    /// Returns the difference f − g of two power series, as a series in x divided by the length of f.
    static Series difference(const Series& f, const Series& g) {
        Series result = f, subtracted = g;
        result.rescale(f.length);
        subtracted.rescale(f.length);
        for (int k = result.count; k < subtracted.count; ++k) result.c[k] = 0;
        result.count = std::max(result.count, subtracted.count);
        for (int k = 0; k < subtracted.count; ++k) result.c[k] -= subtracted.c[k];
        return result;
    }

    Real m_fastest = 0;  ///< larger rate β/γ of the contact, per t0
    Real m_passes = 1;   ///< number of times that a piece of the wave meets the rock
    Real m_smoothEffect = 0;
    Real m_mostDisplaced = 0;
    Real m_mostDeviation = 0;
    Series m_joined;
};

}  // namespace drillwave
