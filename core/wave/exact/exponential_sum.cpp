// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

namespace {

/// ∫ Σ c_m φ_m + Σ q_m ω_m over y from 0: ∫φ_m = ω_m and ∫ω_m = y − Σ_{k≤m} ω_k.
double integralOf(const Coefficients& decays, const Coefficients& rises, double y, double decay) {
    if (rises.count == 0) return decays.rises(y, decay);
    Coefficients sums = rises.sumsFromEach();
    const double straight = sums.c[0] * y;
    for (int m = 0; m < sums.count; ++m) sums.c[m] = decays[m] - sums.c[m];
    for (int m = sums.count; m < decays.count; ++m) sums.c[m] = decays.c[m];
    sums.count = std::max(sums.count, decays.count);
    return straight + sums.rises(y, decay);
}

}  // namespace

template <int lines>
double ExponentialSum<lines>::curveMagnitude() const {
    double sum = std::abs(curve.c1) * length + curve.hammer.magnitude();
    eachLine<lines>([&](int i) {
        if (const Coefficients& rises = curve.rises[i]; rises.count)
            sum += rises.magnitude() * std::min((*rates)[i] * length, 1.0);
    });
    return sum;
}

template <int lines>
double ExponentialSum<lines>::mostOfHammer() const {
    return curve.hammer.amplitude() + std::max(curve.hammer.decay, 0.0);
}

template <int lines>
double ExponentialSum<lines>::mostOfRises() const {
    double most = std::max(curve.c1 * length, 0.0);
    eachLine<lines>([&](int i) {
        if (const Coefficients& rises = curve.rises[i]; rises.count)
            most += rises.mostRisen() * std::min((*rates)[i] * length, 1.0);
    });
    return most;
}

template <int lines>
double ExponentialSum<lines>::leastOfRises() const {
    double least = std::min(curve.c1 * length, 0.0);
    eachLine<lines>([&](int i) {
        if (const Coefficients& rises = curve.rises[i]; rises.count)
            least += rises.leastRisen() * std::min((*rates)[i] * length, 1.0);
    });
    return least;
}

template <int lines>
double ExponentialSum<lines>::mostIntegralOfCurve() const {
    // c0 + c1 x together: a ramp down to zero has a large constant
    const double straight = std::max({0.0, c0, c0 + curve.c1 * length}) - std::max(c0, 0.0);
    double most = straight * length;
    eachLine<lines>([&](int i) {
        if (const Coefficients& rises = curve.rises[i]; rises.count)
            most += rises.mostRisen() * std::min((*rates)[i] * length, 1.0) * length;
    });
    const HammerTerms& hammer = curve.hammer;
    if (hammer.present)
        most += hammer.amplitude() * length + std::max(hammer.decay, 0.0) * std::min(length, 1.0);
    return most;
}

template <int lines>
double ExponentialSum<lines>::valueOfCurved(double x) const {
    double f = c0 + curve.c1 * x;
    eachLine<lines>([&](int i) {
        if (!hasLine(i)) return;
        const double y = (*rates)[i] * x, decay = decayOver(i, x);
        f += decays[i].decays(y, decay) + curve.rises[i].rises(y, decay);
    });
    return curve.hammer.present ? f + curve.hammer.value(x) : f;
}

template <int lines>
double ExponentialSum<lines>::integralOfCurved(double x) const {
    double f = (c0 + curve.c1 * x / 2) * x;
    eachLine<lines>([&](int i) {
        if (!hasLine(i)) return;
        const double y = (*rates)[i] * x, decay = decayOver(i, x);
        f += integralOf(decays[i], curve.rises[i], y, decay) / (*rates)[i];
    });
    return curve.hammer.present ? f + curve.hammer.integral(x) : f;
}

template <int lines>
double ExponentialSum<lines>::impulseOfCurved() const {
    if (std::isnan(curve.impulse)) curve.impulse = integralOfCurved(length);
    return curve.impulse;
}

/// Turns the rises up to x into a constant.
template <int lines>
void ExponentialSum<lines>::dropFrontOfCurve(double x, const std::array<double, lines>& decaysTo) {
    c0 += curve.c1 * x;
    eachLine<lines>([&](int i) {
        Coefficients& rises = curve.rises[i];
        if (!rises.count) return;
        c0 += rises.rises((*rates)[i] * x, decaysTo[i]);
        rises.shift((*rates)[i] * x, decaysTo[i]);
    });
    if (curve.hammer.present) curve.hammer.dropFront(x);
    curve.impulse = Curve::unknown;
}

template <int lines>
void ExponentialSum<lines>::trimCurve(double negligible) {
    for (Coefficients& rises : curve.rises) rises.trim(negligible);
    if (curve.hammer.present) curve.hammer.trim(negligible);
    if (std::abs(c0) + std::abs(curve.c1) * length <= negligible) c0 = curve.c1 = 0;
    isCurved = !curve.isZero();
}

template struct ExponentialSum<2>;
template struct ExponentialSum<3>;

}  // namespace drillwave
