// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of constants and decays of the rates that the lines of a law have, and of what ramps and curved hammer
// forces leave: the fast representation of the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drillwave {

// The terms of an exponential sum: decays and rises of one rate, and what a curved hammer force leaves.

/// The distance from 1 to the next double.
inline constexpr double doubleEpsilon = std::numeric_limits<double>::epsilon();

/// Coefficients c_m, m = 0, 1, …, of one kind of term of one rate: of the decays φ_m(y) = e^{−y} y^m/m! or of
/// the rises ω_m(y) = ∫0..y φ_m = 1 − Σ_{k≤m} φ_k(y), y = λx.
///
/// The factorials make the resonant response a mere shift: F' + λF = 2λ φ_m gives F = 2 φ_{m+1}, and the same
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
    /// Moves the origin to x: value(y) becomes what value(x + y) was.
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

/// The rates of F' = a(2g − F), per t0, which are the slopes of the lines of the law (T16): β, β/γ, and s_j β
/// behind each corner.
template <int lines>
using LineRates = std::array<double, lines>;

/// f(x) = c0 + Σ decays of each rate (+ curve) on 0 ≤ x ≤ length.
///
/// Blows made of steps leave nothing but constants and decays, and should not pay for more: a sum that is not
/// curved neither copies nor looks at its curved terms, which may hold what an earlier one has left. Nor
/// should a law without corners pay for their rates: how many there are, the compiler knows.
template <int lines>
struct ExponentialSum {
    using Curve = CurvedTerms<lines>;

    double length = 0;
    double c0 = 0;
    const LineRates<lines>* rates = nullptr;
    mutable std::array<double, lines> wholeDecays = notComputed();  ///< e^{−rate·length}; negative: not yet
    bool isCurved = false;
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
    /// Its curved terms, none before.
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
    /// Returns whether it has terms of that rate.
    bool hasLine(int i) const { return decays[i].count || (isCurved && curve.rises[i].count); }
    /// Returns the rises of that rate.
    const Coefficients& risesOf(int i) const { return isCurved ? curve.rises[i] : noTerms; }
    bool hasHammer() const { return isCurved && curve.hammer.present; }
    bool hasSine() const { return hasHammer() && curve.hammer.hasSine(); }

    double startValue() const {
        double steps = c0;
        eachLine<lines>([&](int i) { steps += decays[i][0]; });
        return isCurved ? steps + curve.hammer.startValue() : steps;
    }
    double magnitude() const {
        double steps = std::abs(c0);
        eachLine<lines>([&](int i) { steps += decays[i].magnitude(); });
        return isCurved ? steps + curveMagnitude() : steps;
    }
    /// Whether bounds say that f ≥ 0: enough for it, not needed.
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
    /// An upper bound of f.
    double mostValue() const {
        const double steps = mostOfSteps();
        return isCurved ? steps + mostOfRises() + mostOfHammer() : steps;
    }
    /// An upper bound of ∫f over [0, x] for every x up to the length, and 0.
    double mostIntegral() const {
        double most = std::max(c0, 0.0) * length;
        eachLine<lines>([&](int i) {
            if (decays[i].count) most += decays[i].mostRisen() * std::min(1 / (*rates)[i], length);
        });
        return isCurved ? most + mostIntegralOfCurve() : most;
    }

    /// An upper bound of what the terms add up to over the length, whatever their signs: what the rounding of
    /// ∫f is relative to.
    double integralOfSizes() const {
        constexpr double lasting = Coefficients::capacity;  // for so many 1/λ at most a decay is that large
        double sum = std::abs(c0) * length;
        eachLine<lines>([&](int i) {
            if (decays[i].count) sum += decays[i].magnitude() * std::min(lasting / (*rates)[i], length);
        });
        return isCurved ? sum + curveMagnitude() * length : sum;
    }

    /// e^{−λx} of that rate.
    double decayOver(int i, double x) const {
        if (x != length) return std::exp(-(*rates)[i] * x);
        if (wholeDecays[i] < 0) wholeDecays[i] = std::exp(-(*rates)[i] * x);
        return wholeDecays[i];
    }
    double value(double x) const {
        if (isCurved) [[unlikely]]
            return valueOfCurved(x);
        double f = c0;
        eachLine<lines>([&](int i) {
            if (decays[i].count) f += decays[i].decays((*rates)[i] * x, decayOver(i, x));
        });
        return f;
    }
    double integral(double x) const {
        if (isCurved) [[unlikely]]
            return integralOfCurved(x);
        double f = c0 * x;
        eachLine<lines>([&](int i) {
            if (decays[i].count) f += decays[i].rises((*rates)[i] * x, decayOver(i, x)) / (*rates)[i];
        });
        return f;
    }
    /// ∫f over the length. Free flight asks for it in every round trip: what is curved keeps it.
    double impulse() const {
        if (isCurved) [[unlikely]]
            return impulseOfCurved();
        return integral(length);
    }
    /// The function seen from x on, with the decays up to there given, where it has terms of their rates.
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
    void shorten(double x) {
        if (x == length) return;
        length = x;
        forgetDecays();
        if (isCurved) [[unlikely]]
            curve.impulse = Curve::unknown;
    }
    /// Drops what is at most that.
    void trim(double negligible) {
        eachLine<lines>([&](int i) { decays[i].trim(negligible); });
        if (isCurved) [[unlikely]]
            trimCurve(negligible);
        else if (std::abs(c0) <= negligible)
            c0 = 0;
    }

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
    // the same for sums that are curved, out of the way of those that are not
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
