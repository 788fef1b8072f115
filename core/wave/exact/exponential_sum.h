// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of c0 + c1 x, decaying exponentials of two fixed rates and what a curved hammer force leaves: the fast
// representation of the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/contact/contact_rates.h"

namespace drillwave {

/// The coefficients of φ_m(λx) = e^{−λx}(λx)^m/m!, m = 0, 1, …, for one rate λ. The factorials make the
/// resonant response a mere shift: F' + λF = 2λ φ_m gives F = 2 φ_{m+1}.
struct DecayTerms {
    static constexpr int capacity = 8;
    int count = 0;
    std::array<double, capacity> c;

    DecayTerms() {}
    DecayTerms(const DecayTerms& other) { *this = other; }
    DecayTerms& operator=(const DecayTerms& other) {
        count = other.count;
        for (int m = 0; m < count; ++m) c[m] = other.c[m];
        return *this;
    }

    double start() const { return count > 0 ? c[0] : 0.0; }
    double slopeAtStart() const { return (count > 1 ? c[1] : 0.0) - start(); }  ///< in units of the rate
    bool allAtLeastZero() const {
        return std::all_of(c.begin(), c.begin() + count, [](double v) { return v >= 0; });
    }
    bool allAtMostZero() const {
        return std::all_of(c.begin(), c.begin() + count, [](double v) { return v <= 0; });
    }
    double magnitude() const {
        double sum = 0;
        for (int m = 0; m < count; ++m) sum += std::abs(c[m]);
        return sum;
    }
    double positivePart() const {
        double sum = 0;
        for (int m = 0; m < count; ++m) sum += std::max(c[m], 0.0);
        return sum;
    }
    /// Σ c_m φ_m(y), with e^{−y} given.
    double value(double y, double decay) const {
        if (count == 0) return 0;
        double sum = c[count - 1];
        for (int m = count - 1; m > 0; --m) sum = sum * (y / m) + c[m - 1];
        return sum * decay;
    }
    /// Σ c_m ∫0..y φ_m = Σ c_m (1 − Σ_{k≤m} φ_k(y)).
    double integral(double y, double decay) const {
        double sum = 0, total = 0, power = 1, reached = 0;
        for (int m = 0; m < count; ++m) {
            reached += power;
            sum += c[m] * reached;
            total += c[m];
            power *= y / (m + 1);
        }
        return decay == 0 ? total : total - decay * sum;
    }
    /// The same terms seen from y on.
    void dropFront(double y, double decay) {
        for (int k = 0; k < count; ++k) {
            double sum = c[count - 1];
            for (int m = count - 1; m > k; --m) sum = sum * (y / (m - k)) + c[m - 1];
            c[k] = sum * decay;
        }
    }
    void trim(double negligible) {
        if (magnitude() <= negligible)
            count = 0;
        else
            while (count > 0 && c[count - 1] == 0) --count;
    }
};

/// s sin πx + k cos πx + d e^{−x}, x in t0: what a half sine and an exponential blow leave in every wave. None
/// of the three grows by reflection, unless a rate of the contact is near that of e^{−x}.
struct HammerTerms {
    double sine = 0, cosine = 0, decay = 0;
    bool present = false;  ///< most pieces have none, and should not pay for them

    double startValue() const { return cosine + decay; }
    /// Amplitude of the sine.
    double amplitude() const { return std::abs(sine) + std::abs(cosine); }
    double magnitude() const { return amplitude() + std::abs(decay); }
    bool allAtLeastZero(double length) const {
        // at most a half sine: a stretch below zero in it would hold an end or the middle
        return !present || (decay >= 0 && cosine >= 0 && length <= 1 && wave(length / 2) >= 0 &&
                            wave(length) >= 0);
    }
    bool allAtMostZero(double length) const { return negated().allAtLeastZero(length); }
    HammerTerms negated() const { return {-sine, -cosine, -decay, present}; }

    double value(double x) const { return wave(x) + (decay == 0 ? 0 : decay * std::exp(-x)); }
    double integral(double x) const {
        double sum = decay == 0 ? 0 : -decay * std::expm1(-x);
        if (hasSine()) {
            const double half = std::sin(pi / 2 * x);
            sum += (sine * 2 * half * half + cosine * std::sin(pi * x)) / pi;
        }
        return sum;
    }
    /// The same terms seen from x on.
    void dropFront(double x) {
        if (hasSine()) {
            const double s = std::sin(pi * x), c = std::cos(pi * x), before = sine;
            sine = before * c - cosine * s;
            cosine = cosine * c + before * s;
        }
        if (decay != 0) decay *= std::exp(-x);
    }
    void trim(double negligible) {
        if (magnitude() <= negligible) *this = {};
    }

    static constexpr double pi = 3.14159265358979323846;
    bool hasSine() const { return sine != 0 || cosine != 0; }

  private:
    double wave(double x) const {
        return hasSine() ? sine * std::sin(pi * x) + cosine * std::cos(pi * x) : 0.0;
    }
};

/// f(x) = c0 + c1 x + Σ primary + Σ elastic + hammer on 0 ≤ x ≤ length.
struct ExponentialSum {
    double length = 0;
    double c0 = 0, c1 = 0;
    DecayTerms primary, elastic;
    HammerTerms hammer;
    mutable double primaryDecay = -1, elasticDecay = -1;  ///< e^{−rate·length}; negative: not computed yet
    const ContactRates<double>* rates = nullptr;

    static ExponentialSum zero(double length) {
        ExponentialSum f;
        f.length = length;
        return f;
    }
    bool isZero() const {
        return c0 == 0 && c1 == 0 && primary.count == 0 && elastic.count == 0 && !hammer.present;
    }
    double startValue() const { return c0 + primary.start() + elastic.start() + hammer.startValue(); }
    double magnitude() const {
        return std::abs(c0) + std::abs(c1) * length + primary.magnitude() + elastic.magnitude() +
               hammer.magnitude();
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
        return std::max(c0, c0 + c1 * length) + primary.positivePart() + elastic.positivePart() +
               hammer.amplitude() + std::max(hammer.decay, 0.0);
    }

    double decayOver(double x, double rate, double& whole) const {
        if (x != length) return std::exp(-rate * x);
        if (whole < 0) whole = std::exp(-rate * x);
        return whole;
    }
    double value(double x) const {
        double f = c0 + c1 * x;
        if (primary.count) f += primary.value(rates->primary * x, decayOver(x, rates->primary, primaryDecay));
        if (elastic.count) f += elastic.value(rates->elastic * x, decayOver(x, rates->elastic, elasticDecay));
        if (hammer.present) f += hammer.value(x);
        return f;
    }
    double integral(double x) const {
        double f = (c0 + c1 * x / 2) * x;
        if (primary.count)
            f += primary.integral(rates->primary * x, decayOver(x, rates->primary, primaryDecay)) /
                 rates->primary;
        if (elastic.count)
            f += elastic.integral(rates->elastic * x, decayOver(x, rates->elastic, elasticDecay)) /
                 rates->elastic;
        if (hammer.present) f += hammer.integral(x);
        return f;
    }
    /// The function seen from x on, with the decays up to there given.
    void dropFront(double x, double primaryTo, double elasticTo) {
        c0 += c1 * x;
        if (primary.count) primary.dropFront(rates->primary * x, primaryTo);
        if (elastic.count) elastic.dropFront(rates->elastic * x, elasticTo);
        if (hammer.present) hammer.dropFront(x);
        length -= x;
        primaryDecay = elasticDecay = -1;
    }
    void dropFront(double x) {
        dropFront(x, primary.count ? decayOver(x, rates->primary, primaryDecay) : 0,
                  elastic.count ? decayOver(x, rates->elastic, elasticDecay) : 0);
    }
    void shorten(double x) {
        if (x == length) return;
        length = x;
        primaryDecay = elasticDecay = -1;
    }
};

}  // namespace drillwave
