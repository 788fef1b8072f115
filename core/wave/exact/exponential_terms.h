// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of an exponential sum: decays and rises of one rate, and what a curved hammer force leaves.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace drillwave {

/// Coefficients c_m, m = 0, 1, …, of one kind of term of one rate.
struct Coefficients {
    static constexpr int capacity = 8;
    int count = 0;
    std::array<double, capacity> c;

    Coefficients() {}
    Coefficients(const Coefficients& other) { *this = other; }
    Coefficients& operator=(const Coefficients& other) {
        count = other.count;
        for (int m = 0; m < count; ++m) c[m] = other.c[m];
        return *this;
    }

    double operator[](int m) const { return m < count ? c[m] : 0.0; }
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
    void trim(double negligible) {
        if (magnitude() <= negligible)
            count = 0;
        else
            while (count > 0 && c[count - 1] == 0) --count;
    }

    /// Σ c_m φ_m(y), φ_m(y) = e^{−y} y^m/m!, with e^{−y} given.
    double decays(double y, double decay) const {
        if (count == 0) return 0;
        double sum = c[count - 1];
        for (int m = count - 1; m > 0; --m) sum = sum * (y / m) + c[m - 1];
        return sum * decay;
    }
    /// Σ c_m ω_m(y), ω_m = ∫0..y φ_m = 1 − Σ_{k≤m} φ_k(y), to rounding of Σ|c_m| min(1, y).
    double rises(double y, double decay) const {
        double omega = y < 0.5 ? -std::expm1(-y) : 1 - decay;
        double sum = 0, phi = decay;
        for (int m = 0; m < count; ++m) {
            sum += c[m] * omega;
            phi *= y / (m + 1);
            omega -= phi;
        }
        return sum;
    }
    /// The coefficients of the same decays seen from y on.
    void shift(double y, double decay) {
        for (int k = 0; k < count; ++k) {
            double sum = c[count - 1];
            for (int m = count - 1; m > k; --m) sum = sum * (y / (m - k)) + c[m - 1];
            c[k] = sum * decay;
        }
    }
};

/// Σ c_m φ_m(λx) + Σ q_m ω_m(λx) for one rate λ; y = λx below, and e^{−y} is given.
///
/// The factorials make the resonant response a mere shift: F' + λF = 2λ φ_m gives F = 2 φ_{m+1}, and likewise
/// for ω_m. Ramps leave rises: x − ω_0(λx)/λ and what follows from it would be differences of large constants
/// and decays where λx is small.
struct RateTerms {
    Coefficients decays, rises;

    bool isZero() const { return decays.count == 0 && rises.count == 0; }
    double start() const { return decays[0]; }
    bool allAtLeastZero() const { return decays.allAtLeastZero() && rises.allAtLeastZero(); }
    bool allAtMostZero() const { return decays.allAtMostZero() && rises.allAtMostZero(); }
    /// Sums of the largest values of the terms up to y.
    double magnitude(double y) const { return decays.magnitude() + rises.magnitude() * std::min(y, 1.0); }
    double positivePart(double y) const {
        return decays.positivePart() + rises.positivePart() * std::min(y, 1.0);
    }
    double value(double y, double decay) const {
        return decays.decays(y, decay) + (rises.count ? rises.rises(y, decay) : 0.0);
    }
    /// ∫ over y from 0.
    double integral(double y, double decay) const {
        double sum = decays.rises(y, decay);
        if (rises.count) {
            const Coefficients sums = sumsFromEach(rises);
            sum += sums.c[0] * y - sums.rises(y, decay);
        }
        return sum;
    }
    /// The same terms seen from y on; what has risen until then becomes a constant, which is returned.
    double dropFront(double y, double decay) {
        decays.shift(y, decay);
        if (rises.count == 0) return 0;
        const double risen = rises.rises(y, decay);
        rises.shift(y, decay);
        return risen;
    }
    void trim(double negligible) {
        decays.trim(negligible);
        rises.trim(negligible);
    }

    /// Σ_{m≥k} q_m for each k: ∫ω_m dy = y − Σ_{k≤m} ω_k.
    static Coefficients sumsFromEach(const Coefficients& terms) {
        Coefficients sums = terms;
        for (int k = terms.count - 2; k >= 0; --k) sums.c[k] += sums.c[k + 1];
        return sums;
    }
};

/// s sin πx + k cos πx + d e^{−x}, x in t0: what a half sine and an exponential blow leave in every wave.
/// None of the three grows by reflection, unless a rate of the contact is near that of e^{−x}.
struct HammerTerms {
    double sine = 0, cosine = 0, decay = 0;
    bool present = false;  ///< most pieces have none, and should not pay for them

    double startValue() const { return cosine + decay; }
    /// Amplitude of the sine.
    double amplitude() const { return std::abs(sine) + std::abs(cosine); }
    double magnitude() const { return amplitude() + std::abs(decay); }
    bool allAtLeastZero(double length) const {
        // at most a half sine: a stretch below zero in it would hold an end or the middle
        return !present ||
               (decay >= 0 && cosine >= 0 && length <= 1 && wave(length / 2) >= 0 && wave(length) >= 0);
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

}  // namespace drillwave
