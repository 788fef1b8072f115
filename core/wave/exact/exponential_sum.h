// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of c0 + c1 x, decays and rises of two fixed rates and what a curved hammer force leaves: the fast
// representation of the exact solver.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/contact/contact_rates.h"
#include "core/wave/exact/exponential_terms.h"

namespace drillwave {

/// f(x) = c0 + c1 x + Σ primary + Σ elastic + hammer on 0 ≤ x ≤ length.
struct ExponentialSum {
    double length = 0;
    double c0 = 0, c1 = 0;
    RateTerms primary, elastic;
    HammerTerms hammer;
    mutable double primaryDecay = -1, elasticDecay = -1;  ///< e^{−rate·length}; negative: not computed yet
    const ContactRates<double>* rates = nullptr;

    static ExponentialSum zero(double length) {
        ExponentialSum f;
        f.length = length;
        return f;
    }
    bool isZero() const {
        return c0 == 0 && c1 == 0 && primary.isZero() && elastic.isZero() && !hammer.present;
    }
    double startValue() const { return c0 + primary.start() + elastic.start() + hammer.startValue(); }
    double magnitude() const {
        double sum = std::abs(c0) + std::abs(c1) * length + hammer.magnitude();
        if (!primary.isZero()) sum += primary.magnitude(rates->primary * length);
        if (!elastic.isZero()) sum += elastic.magnitude(rates->elastic * length);
        return sum;
    }
    /// Whether no term is below zero anywhere: enough for f ≥ 0, not needed for it.
    bool allAtLeastZero() const {
        return c0 >= 0 && c0 + c1 * length >= 0 && primary.allAtLeastZero() && elastic.allAtLeastZero() &&
               hammer.allAtLeastZero(length);
    }
    bool allAtMostZero() const {
        return c0 <= 0 && c0 + c1 * length <= 0 && primary.allAtMostZero() && elastic.allAtMostZero() &&
               hammer.allAtMostZero(length);
    }
    /// An upper bound of f.
    double mostValue() const {
        double sum = std::max(c0, c0 + c1 * length) + hammer.amplitude() + std::max(hammer.decay, 0.0);
        if (!primary.isZero()) sum += primary.positivePart(rates->primary * length);
        if (!elastic.isZero()) sum += elastic.positivePart(rates->elastic * length);
        return sum;
    }

    double decayOver(double x, double rate, double& whole) const {
        if (x != length) return std::exp(-rate * x);
        if (whole < 0) whole = std::exp(-rate * x);
        return whole;
    }
    double value(double x) const {
        double f = c0 + c1 * x;
        if (!primary.isZero())
            f += primary.value(rates->primary * x, decayOver(x, rates->primary, primaryDecay));
        if (!elastic.isZero())
            f += elastic.value(rates->elastic * x, decayOver(x, rates->elastic, elasticDecay));
        if (hammer.present) f += hammer.value(x);
        return f;
    }
    double integral(double x) const {
        double f = (c0 + c1 * x / 2) * x;
        if (!primary.isZero())
            f += primary.integral(rates->primary * x, decayOver(x, rates->primary, primaryDecay)) /
                 rates->primary;
        if (!elastic.isZero())
            f += elastic.integral(rates->elastic * x, decayOver(x, rates->elastic, elasticDecay)) /
                 rates->elastic;
        if (hammer.present) f += hammer.integral(x);
        return f;
    }
    /// The function seen from x on, with the decays up to there given.
    void dropFront(double x, double primaryTo, double elasticTo) {
        c0 += c1 * x;
        if (!primary.isZero()) c0 += primary.dropFront(rates->primary * x, primaryTo);
        if (!elastic.isZero()) c0 += elastic.dropFront(rates->elastic * x, elasticTo);
        if (hammer.present) hammer.dropFront(x);
        length -= x;
        primaryDecay = elasticDecay = -1;
    }
    void dropFront(double x) {
        dropFront(x, primary.isZero() ? 0 : decayOver(x, rates->primary, primaryDecay),
                  elastic.isZero() ? 0 : decayOver(x, rates->elastic, elasticDecay));
    }
    void shorten(double x) {
        if (x == length) return;
        length = x;
        primaryDecay = elasticDecay = -1;
    }
};

}  // namespace drillwave
