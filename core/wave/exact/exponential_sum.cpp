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

double ExponentialSum::curveMagnitude() const {
    double sum = std::abs(curve.c1) * length + curve.hammer.magnitude();
    if (curve.primary.count) sum += curve.primary.magnitude() * std::min(rates->primary * length, 1.0);
    if (curve.elastic.count) sum += curve.elastic.magnitude() * std::min(rates->elastic * length, 1.0);
    return sum;
}

double ExponentialSum::mostOfHammer() const {
    return curve.hammer.amplitude() + std::max(curve.hammer.decay, 0.0);
}

double ExponentialSum::mostOfRises() const {
    double most = std::max(curve.c1 * length, 0.0);
    if (curve.primary.count) most += curve.primary.mostRisen() * std::min(rates->primary * length, 1.0);
    if (curve.elastic.count) most += curve.elastic.mostRisen() * std::min(rates->elastic * length, 1.0);
    return most;
}

double ExponentialSum::leastOfRises() const {
    double least = std::min(curve.c1 * length, 0.0);
    if (curve.primary.count) least += curve.primary.leastRisen() * std::min(rates->primary * length, 1.0);
    if (curve.elastic.count) least += curve.elastic.leastRisen() * std::min(rates->elastic * length, 1.0);
    return least;
}

double ExponentialSum::mostIntegralOfCurve() const {
    // c0 + c1 x together: a ramp down to zero has a large constant
    const double straight = std::max({0.0, c0, c0 + curve.c1 * length}) - std::max(c0, 0.0);
    double most = straight * length;
    if (curve.primary.count)
        most += curve.primary.mostRisen() * std::min(rates->primary * length, 1.0) * length;
    if (curve.elastic.count)
        most += curve.elastic.mostRisen() * std::min(rates->elastic * length, 1.0) * length;
    const HammerTerms& hammer = curve.hammer;
    if (hammer.present)
        most += hammer.amplitude() * length + std::max(hammer.decay, 0.0) * std::min(length, 1.0);
    return most;
}

double ExponentialSum::valueOfCurved(double x) const {
    double f = c0 + curve.c1 * x;
    if (hasPrimary()) {
        const double y = rates->primary * x, decay = primaryOver(x);
        f += primary.decays(y, decay) + curve.primary.rises(y, decay);
    }
    if (hasElastic()) {
        const double y = rates->elastic * x, decay = elasticOver(x);
        f += elastic.decays(y, decay) + curve.elastic.rises(y, decay);
    }
    return curve.hammer.present ? f + curve.hammer.value(x) : f;
}

double ExponentialSum::integralOfCurved(double x) const {
    double f = (c0 + curve.c1 * x / 2) * x;
    if (hasPrimary()) {
        const double y = rates->primary * x, decay = primaryOver(x);
        f += integralOf(primary, curve.primary, y, decay) / rates->primary;
    }
    if (hasElastic()) {
        const double y = rates->elastic * x, decay = elasticOver(x);
        f += integralOf(elastic, curve.elastic, y, decay) / rates->elastic;
    }
    return curve.hammer.present ? f + curve.hammer.integral(x) : f;
}

/// What has risen until then becomes a constant.
double ExponentialSum::impulseOfCurved() const {
    if (std::isnan(curve.impulse)) curve.impulse = integralOfCurved(length);
    return curve.impulse;
}

void ExponentialSum::dropFrontOfCurve(double x, double primaryTo, double elasticTo) {
    c0 += curve.c1 * x;
    if (curve.primary.count) {
        c0 += curve.primary.rises(rates->primary * x, primaryTo);
        curve.primary.shift(rates->primary * x, primaryTo);
    }
    if (curve.elastic.count) {
        c0 += curve.elastic.rises(rates->elastic * x, elasticTo);
        curve.elastic.shift(rates->elastic * x, elasticTo);
    }
    if (curve.hammer.present) curve.hammer.dropFront(x);
    curve.impulse = CurvedTerms::unknown;
}

void ExponentialSum::trimCurve(double negligible) {
    curve.primary.trim(negligible);
    curve.elastic.trim(negligible);
    if (curve.hammer.present) curve.hammer.trim(negligible);
    if (std::abs(c0) + std::abs(curve.c1) * length <= negligible) c0 = curve.c1 = 0;
    isCurved = !curve.isZero();
}

}  // namespace drillwave
