// SPDX-License-Identifier: GPL-3.0-or-later
// Exponential sums: constants, decays with the rates of the lines of a law, and terms that ramps and curved
// hammer forces leave. They are the fast representation of waves in the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drillwave {

// Terms of an exponential sum: decays and rises of one rate, and the terms of a curved hammer force

/// Machine epsilon: distance from 1 to the next larger double.
inline constexpr double doubleEpsilon = std::numeric_limits<double>::epsilon();

/// Coefficients c_m, m = 0, 1, …, of the terms of one rate λ in an exponential sum. The terms are the decays
/// φ_m(y) = e^(−y) y^m/m!, or the rises ω_m(y) = ∫0..y φ_m = 1 − Σ_{k≤m} φ_k(y), with y = λx.
///
/// Because of the factorials, the force at the same rate has shifted coefficients: F' + λF = 2λ φ_m has the
/// solution F = 2 φ_{m+1}, and the same holds for ω_m.
struct Coefficients {
    /// Maximum number of coefficients of one kind of term.
    static constexpr int capacity = 8;
    /// Number of stored coefficients c_0, c_1, …; all later ones are zero.
    int count = 0;
    std::array<double, capacity> c;

    Coefficients() {}
    Coefficients(const Coefficients& other) { *this = other; }
    Coefficients& operator=(const Coefficients& other) {
        count = other.count;
        for (int m = 0; m < count; ++m) c[m] = other.c[m];
        return *this;
    }

    /// Returns the coefficient c_m, zero for m ≥ count.
    double operator[](int m) const { return m < count ? c[m] : 0.0; }
    /// Returns the sum of the absolute coefficients, Σ |c_m|.
    double magnitude() const {
        double sum = 0;
        for (int m = 0; m < count; ++m) sum += std::abs(c[m]);
        return sum;
    }
    /// Returns an upper bound, at least 0, of Σ c_m φ_m(y) for y ≥ 0, with φ_m(y) = e^(−y) y^m/m!. No φ_m is
    /// negative, and their sum is at most 1.
    double most() const {
        double largest = 0;
        for (int m = 0; m < count; ++m) largest = std::max(largest, c[m]);
        return largest;
    }
    /// Returns a lower bound, at most 0, of Σ c_m φ_m(y) for y ≥ 0, with φ_m(y) = e^(−y) y^m/m!.
    double least() const {
        double smallest = 0;
        for (int m = 0; m < count; ++m) smallest = std::min(smallest, c[m]);
        return smallest;
    }
    /// Returns an upper bound, at least 0, of Σ c_m ω_m(y) for y ≥ 0, with ω_m(y) = ∫0..y e^(−z) z^m/m! dz.
    /// Since 1 ≥ ω_0 ≥ ω_1 ≥ …, the sum is a mean of 0 and the partial sums Σ_{k≤m} c_k.
    double mostRisen() const {
        double largest = 0, sum = 0;
        for (int m = 0; m < count; ++m) largest = std::max(largest, sum += c[m]);
        return largest;
    }
    /// Returns a lower bound, at most 0, of Σ c_m ω_m(y) for y ≥ 0, with ω_m(y) = ∫0..y e^(−z) z^m/m! dz.
    double leastRisen() const {
        double smallest = 0, sum = 0;
        for (int m = 0; m < count; ++m) smallest = std::min(smallest, sum += c[m]);
        return smallest;
    }
    /// Drops all coefficients if Σ |c_m| is at most `negligible`, otherwise only zeros at the end of the
    /// list.
    void trim(double negligible) {
        if (count == 0 || std::abs(c[count - 1]) > negligible) return;
        if (magnitude() <= negligible)
            count = 0;
        else
            while (count > 0 && c[count - 1] == 0) --count;
    }

    /// Returns the sum of the decays Σ c_m φ_m(y), φ_m(y) = e^(−y) y^m/m!; `decay` is e^(−y).
    double decays(double y, double decay) const {
        if (count == 0) return 0;
        double sum = c[count - 1];
        for (int m = count - 1; m > 0; --m) sum = sum * (y / m) + c[m - 1];
        return sum * decay;
    }
    /// Returns the sum of the rises Σ c_m ω_m(y), ω_m(y) = ∫0..y φ_m, with a rounding error relative to
    /// Σ|c_m| min(1, y); `decay` is e^(−y).
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
    /// Replaces the coefficients c_m so that Σ c_m φ_m(z) becomes what Σ c_m φ_m(y + z) was before, with
    /// φ_m(y) = e^(−y) y^m/m!. `decay` is e^(−y).
    void shift(double y, double decay) {
        for (int k = 0; k < count; ++k) {
            double sum = c[count - 1];
            for (int m = count - 1; m > k; --m) sum = sum * (y / (m - k)) + c[m - 1];
            c[k] = sum * decay;
        }
    }
    /// Returns the sums s_k = Σ_{m≥k} c_m. They give the integral of rises: ∫Σ c_m ω_m dy = s_0 y − Σ s_k
    /// ω_k.
    Coefficients sumsFromEach() const {
        Coefficients sums = *this;
        for (int k = count - 2; k >= 0; --k) sums.c[k] += sums.c[k + 1];
        return sums;
    }
};

/// Empty list of coefficients, for sums without rises.
inline const Coefficients noTerms;

/// Terms s sin πx + k cos πx + d e^(−x), x in t0, that a half sine and an exponential hammer force leave in
/// every wave. Reflections do not increase them, unless a slope of the bit–rock law is near the rate of
/// e^(−x), 1/t0.
struct HammerTerms {
    /// Coefficients of sin πx, cos πx and e^(−x), in units of F0.
    double sine = 0, cosine = 0, decay = 0;
    /// Whether any of these coefficients may be nonzero. It is false for piecewise linear hammer forces,
    /// which saves work.
    bool present = false;

    /// Returns the value of s sin πx + k cos πx + d e^(−x) at x = 0, in units of F0.
    double startValue() const { return cosine + decay; }
    /// Returns |s| + |k|, an upper bound of the amplitude of s sin πx + k cos πx.
    double amplitude() const { return std::abs(sine) + std::abs(cosine); }
    /// Returns an upper bound of |s sin πx + k cos πx + d e^(−x)| for x ≥ 0, in units of F0.
    double magnitude() const { return amplitude() + std::abs(decay); }
    /// Returns whether s sin πx + k cos πx + d e^(−x) is certainly ≥ 0 for 0 ≤ x ≤ length; false if that is
    /// not known.
    bool allAtLeastZero(double length) const {
        // the interval is at most a half sine: if the sum were negative inside, an end or the middle would be
        // too
        return !present ||
               (decay >= 0 && cosine >= 0 && length <= 1 && wave(length / 2) >= 0 && wave(length) >= 0);
    }
    /// Returns whether s sin πx + k cos πx + d e^(−x) is certainly ≤ 0 for 0 ≤ x ≤ length; false if that is
    /// not known.
    bool allAtMostZero(double length) const { return negated().allAtLeastZero(length); }
    HammerTerms negated() const { return {-sine, -cosine, -decay, present}; }

    /// Returns the value of s sin πx + k cos πx + d e^(−x), in units of F0.
    double value(double x) const { return wave(x) + (decay == 0 ? 0 : decay * std::exp(-x)); }
    /// Returns the integral of s sin πx + k cos πx + d e^(−x) from 0 to x, in units of I0.
    double integral(double x) const {
        double sum = decay == 0 ? 0 : -decay * std::expm1(-x);
        if (hasSine()) {
            const double half = std::sin(pi / 2 * x);
            sum += (sine * 2 * half * half + cosine * std::sin(pi * x)) / pi;
        }
        return sum;
    }
    /// Moves the origin of the terms to x: value(y) becomes what value(x + y) was before.
    void dropFront(double x) {
        if (hasSine()) {
            const double s = std::sin(pi * x), c = std::cos(pi * x), before = sine;
            sine = before * c - cosine * s;
            cosine = cosine * c + before * s;
        }
        if (decay != 0) decay *= std::exp(-x);
    }
    /// Sets the coefficients of sin πx, cos πx and e^(−x) to zero if the absolute value of their sum is at
    /// most `negligible`, in units of F0.
    void trim(double negligible) {
        if (magnitude() <= negligible) *this = {};
    }

    static constexpr double pi = 3.14159265358979323846;
    /// Returns whether the terms include sin πx or cos πx.
    bool hasSine() const { return sine != 0 || cosine != 0; }

  private:
    double wave(double x) const {
        return hasSine() ? sine * std::sin(pi * x) + cosine * std::cos(pi * x) : 0.0;
    }
};

/// Calls of(i) for i = 0 … lines − 1. The loop is unrolled, because its overhead would be as large as the
/// work for two terms.
template <int lines, class Of>
[[gnu::always_inline]] inline void eachLine(Of of) {
#pragma GCC unroll 8
    for (int i = 0; i < lines; ++i) of(i);
}

/// Coefficients of one kind of term, decays e^(−λx) (λx)^m/m! or their integrals (rises). The array has one
/// list for each of the `lines` rates λ of an exponential sum.
template <int lines>
using TermsOfLines = std::array<Coefficients, lines>;

/// Terms that sloped and curved hammer forces leave in a wave: c1 x + Σ q_m ω_m(λx) for each rate λ, with the
/// rises ω_m(y) = ∫0..y e^(−z) z^m/m! dz, and the terms in `hammer`.
///
/// Linear parts of a hammer force leave rises. Written with constants and decays, x − ω_0(λx)/λ and its
/// reflections would be differences of large numbers where λx is small.
template <int lines>
struct CurvedTerms {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /// Slope c1 of the linear term, in units of F0/t0.
    double c1 = 0;
    /// Coefficients q_m of the rises ω_m(y) = ∫0..y e^(−z) z^m/m! dz, y = λx, for each rate λ.
    TermsOfLines<lines> rises;
    /// Terms s sin πx + k cos πx + d e^(−x) of a curved hammer force.
    HammerTerms hammer;
    /// Stored integral of the whole exponential sum over its length, in units of I0, or `unknown` (NaN). It
    /// must be set to `unknown` whenever coefficients are changed from outside.
    mutable double impulse = unknown;

    bool hasRises() const {
        return std::ranges::any_of(rises, [](const Coefficients& terms) { return terms.count > 0; });
    }
    bool isZero() const { return c1 == 0 && !hasRises() && !hammer.present; }
};

/// Rates a [1/t0] of F' = a(2g − F), one for each line of the bit–rock law: its slopes β, β/γ, and s_j β
/// after each corner (T16).
template <int lines>
using LineRates = std::array<double, lines>;

/// Wave force f(x) on 0 ≤ x ≤ length, x in t0: a constant c0, and Σ c_m φ_m(λx) for each rate λ, with the
/// decays φ_m(y) = e^(−y) y^m/m!. Sloped and curved hammer forces add the terms in `curve`.
///
/// For stepped hammer forces, isCurved is false, and `curve` is neither copied nor read; it may hold old
/// values. The number of rates is a template parameter, so that rock laws without corners take no extra time.
template <int lines>
struct ExponentialSum {
    using Curve = CurvedTerms<lines>;

    /// Length of the interval 0 ≤ x ≤ length on which the wave f(x) is defined, in units of t0.
    double length = 0;
    /// Constant term c0 of the wave, in units of F0.
    double c0 = 0;
    /// Rates λ [1/t0] of the decays e^(−λx) in the sum; the array must outlive the sum.
    const LineRates<lines>* rates = nullptr;
    /// Values of e^(−λ·length) for each rate λ; negative until they are computed.
    mutable std::array<double, lines> wholeDecays = notComputed();
    /// Whether the sum has terms of sloped or curved hammer forces: a linear term, rises (integrals of
    /// decays), or sin πx, cos πx and e^(−x).
    bool isCurved = false;
    /// Coefficients c_m of the decays e^(−λx) (λx)^m/m! for each rate λ, in units of F0.
    TermsOfLines<lines> decays;
    Curve curve;

    ExponentialSum() {}
    ExponentialSum(const ExponentialSum& other) { *this = other; }
    // NOLINTNEXTLINE(bugprone-unhandled-self-assignment): every member is a value
    ExponentialSum& operator=(const ExponentialSum& other) {
        length = other.length;
        c0 = other.c0;
        rates = other.rates;
        wholeDecays = other.wholeDecays;
        isCurved = other.isCurved;
        eachLine<lines>([&](int i) { decays[i] = other.decays[i]; });
        if (isCurved) [[unlikely]]
            curve = other.curve;
        return *this;
    }

    static ExponentialSum zero(double length) {
        ExponentialSum f;
        f.length = length;
        return f;
    }
    /// Returns the terms of sloped and curved hammer forces for writing, and sets isCurved. They are zero if
    /// the sum had none before.
    Curve& makeCurved() {
        if (!isCurved) curve = {};
        isCurved = true;
        curve.impulse = Curve::unknown;
        return curve;
    }
    void forgetDecays() { wholeDecays = notComputed(); }
    bool hasDecays() const {
        bool has = false;
        eachLine<lines>([&](int i) { has |= decays[i].count != 0; });
        return has;
    }
    bool isConstant() const { return !isCurved && !hasDecays(); }
    bool isZero() const { return c0 == 0 && isConstant(); }
    /// Returns whether the sum has terms of the rate λ with the index i: decays e^(−λx) (λx)^m/m! or their
    /// integrals (rises).
    bool hasLine(int i) const { return decays[i].count || (isCurved && curve.rises[i].count); }
    /// Returns the coefficients of the rises (integrals of decays) of the rate with the index i; empty if the
    /// sum is not curved.
    const Coefficients& risesOf(int i) const { return isCurved ? curve.rises[i] : noTerms; }
    bool hasHammer() const { return isCurved && curve.hammer.present; }
    bool hasSine() const { return hasHammer() && curve.hammer.hasSine(); }

    /// Returns the value of the wave at x = 0, in units of F0.
    double startValue() const {
        double steps = c0;
        eachLine<lines>([&](int i) { steps += decays[i][0]; });
        return isCurved ? steps + curve.hammer.startValue() : steps;
    }
    /// Returns an upper bound of |f| over the length of the wave f, in units of F0.
    double magnitude() const {
        double steps = std::abs(c0);
        eachLine<lines>([&](int i) { steps += decays[i].magnitude(); });
        return isCurved ? steps + curveMagnitude() : steps;
    }
    /// Returns whether bounds prove that f ≥ 0. A result of false does not mean that f is negative anywhere.
    bool isAtLeastZero() const {
        double steps = c0;
        eachLine<lines>([&](int i) { steps += decays[i].least(); });
        return steps >= 0 &&
               (!isCurved || (steps + leastOfRises() >= 0 && curve.hammer.allAtLeastZero(length)));
    }
    bool isAtMostZero() const {
        const double steps = mostOfSteps();
        return steps <= 0 &&
               (!isCurved || (steps + mostOfRises() <= 0 && curve.hammer.allAtMostZero(length)));
    }
    /// Returns an upper bound of the wave f over its length, in units of F0.
    double mostValue() const {
        const double steps = mostOfSteps();
        return isCurved ? steps + mostOfRises() + mostOfHammer() : steps;
    }
    /// Returns an upper bound, at least 0, of ∫f over [0, x] for every x up to the length, in units of I0.
    double mostIntegral() const {
        double most = std::max(c0, 0.0) * length;
        eachLine<lines>([&](int i) {
            if (decays[i].count) most += decays[i].mostRisen() * std::min(1 / (*rates)[i], length);
        });
        return isCurved ? most + mostIntegralOfCurve() : most;
    }

    /// Returns an upper bound of the integral of the absolute values of all terms of f over its length, in
    /// units of I0. Times the machine epsilon, it estimates the rounding error of ∫f.
    double integralOfSizes() const {
        constexpr double lasting = Coefficients::capacity;  // number of 1/λ over which a decay may be large
        double sum = std::abs(c0) * length;
        eachLine<lines>([&](int i) {
            if (decays[i].count) sum += decays[i].magnitude() * std::min(lasting / (*rates)[i], length);
        });
        return isCurved ? sum + curveMagnitude() * length : sum;
    }

    /// Returns the decay e^(−λx) for the rate λ with the index i.
    double decayOver(int i, double x) const {
        if (x != length) return std::exp(-(*rates)[i] * x);
        if (wholeDecays[i] < 0) wholeDecays[i] = std::exp(-(*rates)[i] * x);
        return wholeDecays[i];
    }
    /// Returns the value of the wave at x, in units of F0.
    double value(double x) const {
        if (isCurved) [[unlikely]]
            return valueOfCurved(x);
        double f = c0;
        eachLine<lines>([&](int i) {
            if (decays[i].count) f += decays[i].decays((*rates)[i] * x, decayOver(i, x));
        });
        return f;
    }
    /// Returns the integral of the wave from 0 to x, in units of I0.
    double integral(double x) const {
        if (isCurved) [[unlikely]]
            return integralOfCurved(x);
        double f = c0 * x;
        eachLine<lines>([&](int i) {
            if (decays[i].count) f += decays[i].rises((*rates)[i] * x, decayOver(i, x)) / (*rates)[i];
        });
        return f;
    }
    /// Returns ∫f over the length, in units of I0. If isCurved is set, the value is stored, because free
    /// flight needs it in every round trip.
    double impulse() const {
        if (isCurved) [[unlikely]]
            return impulseOfCurved();
        return integral(length);
    }
    /// Removes the interval [0, x] from the wave and moves the origin to x. `decaysTo` holds e^(−λx) for each
    /// rate λ that has terms.
    void dropFront(double x, const std::array<double, lines>& decaysTo) {
        if (isCurved) [[unlikely]]
            dropFrontOfCurve(x, decaysTo);
        eachLine<lines>([&](int i) {
            if (decays[i].count) decays[i].shift((*rates)[i] * x, decaysTo[i]);
        });
        length -= x;
        forgetDecays();
    }
    void dropFront(double x) {
        std::array<double, lines> decaysTo;
        eachLine<lines>([&](int i) { decaysTo[i] = hasLine(i) ? decayOver(i, x) : 0; });
        dropFront(x, decaysTo);
    }
    /// Shortens the interval of the wave to [0, x], x in units of t0.
    void shorten(double x) {
        if (x == length) return;
        length = x;
        forgetDecays();
        if (isCurved) [[unlikely]]
            curve.impulse = Curve::unknown;
    }
    /// Drops terms of the wave that are at most `negligible`, in units of F0.
    void trim(double negligible) {
        eachLine<lines>([&](int i) { decays[i].trim(negligible); });
        if (isCurved) [[unlikely]]
            trimCurve(negligible);
        else if (std::abs(c0) <= negligible)
            c0 = 0;
    }

    /// Returns an upper bound of the absolute value of the terms of sloped and curved hammer forces, in units
    /// of F0.
    double curveMagnitude() const;

  private:
    static constexpr std::array<double, lines> notComputed() {
        std::array<double, lines> none;
        none.fill(-1);
        return none;
    }
    double mostOfSteps() const {
        double steps = c0;
        eachLine<lines>([&](int i) { steps += decays[i].most(); });
        return steps;
    }
    // Parts of the functions above for curved sums; they are separate, so that other sums do not pay for them
    double mostOfHammer() const;
    double mostOfRises() const;
    double leastOfRises() const;
    double mostIntegralOfCurve() const;
    double valueOfCurved(double x) const;
    double integralOfCurved(double x) const;
    double impulseOfCurved() const;
    void dropFrontOfCurve(double x, const std::array<double, lines>& decaysTo);
    void trimCurve(double negligible);
};

}  // namespace drillwave
