// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of constants and decays of the rates that the lines of a law have, and of what ramps and curved hammer
// forces leave: the fast representation of the exact solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/wave/exact/exponential_terms.h"

namespace drillwave {

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
    /// Whether terms of that rate are in it.
    bool hasLine(int i) const { return decays[i].count || (isCurved && curve.rises[i].count); }
    /// What of it rises at that rate.
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
