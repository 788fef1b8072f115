// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_algebra.h"

#include <algorithm>

namespace drillwave {

namespace {

HammerTerms combine(double p, const HammerTerms& g, double q, const HammerTerms& f) {
    return {p * g.sine + q * f.sine, p * g.cosine + q * f.cosine, p * g.decay + q * f.decay, true};
}

}  // namespace

template <int lines>
void combineCurves(double p, const ExponentialSum<lines>& g, double q, const ExponentialSum<lines>& f,
                   ExponentialSum<lines>& out) {
    static const CurvedTerms<lines> none;
    const CurvedTerms<lines>& a = g.isCurved ? g.curve : none;
    const CurvedTerms<lines>& b = f.isCurved ? f.curve : none;
    CurvedTerms<lines>& sum = out.makeCurved();
    sum.c1 = p * a.c1 + q * b.c1;
    eachLine<lines>([&](int i) { combine(p, a.rises[i], q, b.rises[i], sum.rises[i]); });
    sum.hammer = a.hammer.present || b.hammer.present ? combine(p, a.hammer, q, b.hammer) : HammerTerms{};
}

template void combineCurves(double, const ExponentialSum<2>&, double, const ExponentialSum<2>&,
                            ExponentialSum<2>&);
template void combineCurves(double, const ExponentialSum<3>&, double, const ExponentialSum<3>&,
                            ExponentialSum<3>&);

}  // namespace drillwave
