// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of constants and decays of two fixed rates, and of what ramps and curved hammer forces leave: the fast
// representation of the exact solver.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/contact/contact_rates.h"
#include "core/wave/exact/exponential_terms.h"

namespace drillwave {

/// f(x) = c0 + Σ primary + Σ elastic (+ curve) on 0 ≤ x ≤ length.
///
/// Blows made of steps leave nothing but constants and decays, and should not pay for more: a sum that is not
/// curved neither copies nor looks at its curved terms, which may hold what an earlier one has left.
struct ExponentialSum {
    double length = 0;
    double c0 = 0;
    const ContactRates<double>* rates = nullptr;
    mutable double primaryDecay = -1, elasticDecay = -1;  ///< e^{−rate·length}; negative: not computed yet
    bool isCurved = false;
    Coefficients primary, elastic;  ///< decays
    CurvedTerms curve;

    ExponentialSum() {}
    ExponentialSum(const ExponentialSum& other) { *this = other; }
    ExponentialSum& operator=(const ExponentialSum& other) {
        length = other.length;
        c0 = other.c0;
        rates = other.rates;
        primaryDecay = other.primaryDecay;
        elasticDecay = other.elasticDecay;
        isCurved = other.isCurved;
        primary = other.primary;
        elastic = other.elastic;
        if (isCurved) [[unlikely]]
            curve = other.curve;
        return *this;
    }

    static ExponentialSum zero(double length) {
        ExponentialSum f;
        f.length = length;
        return f;
    }
    /// Its curved terms, none before.
    CurvedTerms& makeCurved() {
        if (!isCurved) curve = {};
        isCurved = true;
        curve.impulse = CurvedTerms::unknown;
        return curve;
    }
    bool isConstant() const { return !isCurved && primary.count == 0 && elastic.count == 0; }
    bool isZero() const { return c0 == 0 && isConstant(); }
    bool hasPrimary() const { return primary.count || (isCurved && curve.primary.count); }
    bool hasElastic() const { return elastic.count || (isCurved && curve.elastic.count); }
    bool hasHammer() const { return isCurved && curve.hammer.present; }
    bool hasSine() const { return hasHammer() && curve.hammer.hasSine(); }

    double startValue() const {
        const double steps = c0 + primary[0] + elastic[0];
        return isCurved ? steps + curve.hammer.startValue() : steps;
    }
    double magnitude() const {
        const double steps = std::abs(c0) + primary.magnitude() + elastic.magnitude();
        return isCurved ? steps + curveMagnitude() : steps;
    }
    /// Whether bounds say that f ≥ 0: enough for it, not needed.
    bool isAtLeastZero() const {
        const double steps = c0 + primary.least() + elastic.least();
        return steps >= 0 &&
               (!isCurved || (steps + leastOfRises() >= 0 && curve.hammer.allAtLeastZero(length)));
    }
    bool isAtMostZero() const {
        const double steps = c0 + primary.most() + elastic.most();
        return steps <= 0 &&
               (!isCurved || (steps + mostOfRises() <= 0 && curve.hammer.allAtMostZero(length)));
    }
    /// An upper bound of f.
    double mostValue() const {
        const double steps = c0 + primary.most() + elastic.most();
        return isCurved ? steps + mostOfRises() + mostOfHammer() : steps;
    }
    /// An upper bound of ∫f over [0, x] for every x up to the length, and 0.
    double mostIntegral() const {
        double most = std::max(c0, 0.0) * length;
        if (primary.count) most += primary.mostRisen() * std::min(1 / rates->primary, length);
        if (elastic.count) most += elastic.mostRisen() * std::min(1 / rates->elastic, length);
        return isCurved ? most + mostIntegralOfCurve() : most;
    }

    /// An upper bound of what the terms add up to over the length, whatever their signs: what the rounding of
    /// ∫f is relative to.
    double integralOfSizes() const {
        constexpr double lasting = Coefficients::capacity;  // for so many 1/λ at most a decay is that large
        double sum = std::abs(c0) * length;
        if (primary.count) sum += primary.magnitude() * std::min(lasting / rates->primary, length);
        if (elastic.count) sum += elastic.magnitude() * std::min(lasting / rates->elastic, length);
        return isCurved ? sum + curveMagnitude() * length : sum;
    }

    double primaryOver(double x) const { return decayOver(x, rates->primary, primaryDecay); }
    double elasticOver(double x) const { return decayOver(x, rates->elastic, elasticDecay); }
    double value(double x) const {
        if (isCurved) [[unlikely]]
            return valueOfCurved(x);
        double f = c0;
        if (primary.count) f += primary.decays(rates->primary * x, primaryOver(x));
        if (elastic.count) f += elastic.decays(rates->elastic * x, elasticOver(x));
        return f;
    }
    double integral(double x) const {
        if (isCurved) [[unlikely]]
            return integralOfCurved(x);
        double f = c0 * x;
        if (primary.count) f += primary.rises(rates->primary * x, primaryOver(x)) / rates->primary;
        if (elastic.count) f += elastic.rises(rates->elastic * x, elasticOver(x)) / rates->elastic;
        return f;
    }
    /// ∫f over the length. Free flight asks for it in every round trip: what is curved keeps it.
    double impulse() const {
        if (isCurved) [[unlikely]]
            return impulseOfCurved();
        return integral(length);
    }
    /// The function seen from x on, with the decays up to there given.
    void dropFront(double x, double primaryTo, double elasticTo) {
        if (isCurved) [[unlikely]]
            dropFrontOfCurve(x, primaryTo, elasticTo);
        if (primary.count) primary.shift(rates->primary * x, primaryTo);
        if (elastic.count) elastic.shift(rates->elastic * x, elasticTo);
        length -= x;
        primaryDecay = elasticDecay = -1;
    }
    void dropFront(double x) {
        dropFront(x, hasPrimary() ? primaryOver(x) : 0, hasElastic() ? elasticOver(x) : 0);
    }
    void shorten(double x) {
        if (x == length) return;
        length = x;
        primaryDecay = elasticDecay = -1;
        if (isCurved) [[unlikely]]
            curve.impulse = CurvedTerms::unknown;
    }
    /// Drops what is at most that.
    void trim(double negligible) {
        primary.trim(negligible);
        elastic.trim(negligible);
        if (isCurved) [[unlikely]]
            trimCurve(negligible);
        else if (std::abs(c0) <= negligible)
            c0 = 0;
    }

    double curveMagnitude() const;

  private:
    double decayOver(double x, double rate, double& whole) const {
        if (x != length) return std::exp(-rate * x);
        if (whole < 0) whole = std::exp(-rate * x);
        return whole;
    }
    // the same for sums that are curved, out of the way of those that are not
    double mostOfHammer() const;
    double mostOfRises() const;
    double leastOfRises() const;
    double mostIntegralOfCurve() const;
    double valueOfCurved(double x) const;
    double integralOfCurved(double x) const;
    double impulseOfCurved() const;
    void dropFrontOfCurve(double x, double primaryTo, double elasticTo);
    void trimCurve(double negligible);
};

}  // namespace drillwave
