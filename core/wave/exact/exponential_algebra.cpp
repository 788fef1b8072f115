// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_algebra.h"

#include <algorithm>

namespace drillwave {
namespace {

HammerTerms combine(double p, const HammerTerms& g, double q, const HammerTerms& f) {
    return {p * g.sine + q * f.sine, p * g.cosine + q * f.cosine, p * g.decay + q * f.decay, true};
}

}  // namespace

void combineCurves(double p, const ExponentialSum& g, double q, const ExponentialSum& f,
                   ExponentialSum& out) {
    static const CurvedTerms none;
    const CurvedTerms& a = g.isCurved ? g.curve : none;
    const CurvedTerms& b = f.isCurved ? f.curve : none;
    CurvedTerms& sum = out.makeCurved();
    sum.c1 = p * a.c1 + q * b.c1;
    combine(p, a.primary, q, b.primary, sum.primary);
    combine(p, a.elastic, q, b.elastic, sum.elastic);
    sum.hammer = a.hammer.present || b.hammer.present ? combine(p, a.hammer, q, b.hammer) : HammerTerms{};
}

}  // namespace drillwave
