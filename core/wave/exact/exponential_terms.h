// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of an exponential sum: decays and rises of one rate, and what a curved hammer force leaves.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drillwave {

/// The distance from 1 to the next double.
inline constexpr double doubleEpsilon = std::numeric_limits<double>::epsilon();

/// Coefficients c_m, m = 0, 1, …, of one kind of term of one rate: of the decays φ_m(y) = e^{−y} y^m/m! or of
/// the rises ω_m(y) = ∫0..y φ_m = 1 − Σ_{k≤m} φ_k(y), y = λx.
///
/// The factorials make the resonant response a mere shift: F' + λF = 2λ φ_m gives F = 2 φ_{m+1}, and likewise
/// for ω_m.
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
    double magnitude() const {
        double sum = 0;
        for (int m = 0; m < count; ++m) sum += std::abs(c[m]);
        return sum;
    }
    /// Bounds of Σ c_m φ_m, and 0: no φ_m is negative, and together they are at most 1.
    double most() const {
        double largest = 0;
        for (int m = 0; m < count; ++m) largest = std::max(largest, c[m]);
        return largest;
    }
    double least() const {
        double smallest = 0;
        for (int m = 0; m < count; ++m) smallest = std::min(smallest, c[m]);
        return smallest;
    }
    /// Bounds of Σ c_m ω_m, and 0: as 1 ≥ ω_0 ≥ ω_1 ≥ … it is a mean of the partial sums Σ_{k≤m} c_k.
    double mostRisen() const {
        double largest = 0, sum = 0;
        for (int m = 0; m < count; ++m) largest = std::max(largest, sum += c[m]);
        return largest;
    }
    double leastRisen() const {
        double smallest = 0, sum = 0;
        for (int m = 0; m < count; ++m) smallest = std::min(smallest, sum += c[m]);
        return smallest;
    }
    void trim(double negligible) {
        if (count == 0 || std::abs(c[count - 1]) > negligible) return;
        if (magnitude() <= negligible)
            count = 0;
        else
            while (count > 0 && c[count - 1] == 0) --count;
    }

    /// Σ c_m φ_m(y), with e^{−y} given.
    double decays(double y, double decay) const {
        if (count == 0) return 0;
        double sum = c[count - 1];
        for (int m = count - 1; m > 0; --m) sum = sum * (y / m) + c[m - 1];
        return sum * decay;
    }
    /// Σ c_m ω_m(y), to rounding of Σ|c_m| min(1, y).
    double rises(double y, double decay) const {
        if (count == 0) return 0;
        double omega = y < 0.5 ? -std::expm1(-y) : 1 - decay;
        double sum = c[0] * omega, phi = decay;
        for (int m = 1; m < count; ++m) {
            phi *= y / m;
            omega -= phi;
            sum += c[m] * omega;
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
    /// Σ_{m≥k} c_m for each k: ∫ω_m dy = y − Σ_{k≤m} ω_k.
    Coefficients sumsFromEach() const {
        Coefficients sums = *this;
        for (int k = count - 2; k >= 0; --k) sums.c[k] += sums.c[k + 1];
        return sums;
    }
};

inline const Coefficients noTerms;

/// s sin πx + k cos πx + d e^{−x}, x in t0: what a half sine and an exponential blow leave in every wave.
/// None of the three grows by reflection, unless a rate of the contact is near that of e^{−x}.
struct HammerTerms {
    double sine = 0, cosine = 0, decay = 0;
    bool present = false;  ///< ramps leave none, and should not pay for them

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

/// Does `of(i)` for each of the lines of a law, one after the other and not in a loop: that of two terms
/// costs as much as they.
template <int lines, class Of>
[[gnu::always_inline]] inline void eachLine(Of of) {
#pragma GCC unroll 8
    for (int i = 0; i < lines; ++i) of(i);
}

/// The terms of each of the rates of a sum.
template <int lines>
using TermsOfLines = std::array<Coefficients, lines>;

/// c1 x + Σ q_m ω_m of each rate + hammer: what ramps and curved blows leave besides constants and decays.
///
/// Ramps leave rises: x − ω_0(λx)/λ and what follows from it would be differences of large constants and
/// decays where λx is small.
template <int lines>
struct CurvedTerms {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double c1 = 0;
    TermsOfLines<lines> rises;
    HammerTerms hammer;
    /// ∫ of the whole sum over its length, or unknown: whoever sets coefficients from outside makes it so.
    mutable double impulse = unknown;

    bool hasRises() const {
        return std::ranges::any_of(rises, [](const Coefficients& terms) { return terms.count > 0; });
    }
    bool isZero() const { return c1 == 0 && !hasRises() && !hammer.present; }
};

}  // namespace drillwave
