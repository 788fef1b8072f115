// SPDX-License-Identifier: GPL-3.0-or-later
// Differences and multiples of exponential sums, term by term.
#pragma once

#include <algorithm>

#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// out = p·g + q·f
inline void combine(double p, const Coefficients& g, double q, const Coefficients& f, Coefficients& out) {
    const int common = std::min(g.count, f.count);
    for (int m = 0; m < common; ++m) out.c[m] = p * g.c[m] + q * f.c[m];
    for (int m = common; m < g.count; ++m) out.c[m] = p * g.c[m];
    for (int m = common; m < f.count; ++m) out.c[m] = q * f.c[m];
    out.count = std::max(g.count, f.count);
}

/// The slope of Σ c_m φ_m is Σ (c_{m+1} − c_m) φ_m, times the rate: here times `factor`.
inline void differences(const Coefficients& terms, double factor, Coefficients& slope) {
    slope.count = terms.count;
    const int last = terms.count - 1;
    for (int m = 0; m < last; ++m) slope.c[m] = factor * (terms.c[m + 1] - terms.c[m]);
    if (last >= 0) slope.c[last] = -factor * terms.c[last];
}

/// The curved terms of out = p·g + q·f, where g or f has any.
template <int lines>
void combineCurves(double p, const ExponentialSum<lines>& g, double q, const ExponentialSum<lines>& f,
                   ExponentialSum<lines>& out);

/// out = p·g + q·f; `out` is another sum. It has the length and the decays of g.
template <int lines>
inline void combine(double p, const ExponentialSum<lines>& g, double q, const ExponentialSum<lines>& f,
                    ExponentialSum<lines>& out) {
    if (g.isCurved || f.isCurved) [[unlikely]]
        combineCurves(p, g, q, f, out);
    else
        out.isCurved = false;
    out.length = g.length;
    out.c0 = p * g.c0 + q * f.c0;
    eachLine<lines>([&](int i) { combine(p, g.decays[i], q, f.decays[i], out.decays[i]); });
    out.wholeDecays = g.wholeDecays;
    out.rates = g.rates;
}

/// out = −f; both may be the same.
template <int lines>
inline void negate(const ExponentialSum<lines>& f, ExponentialSum<lines>& out) {
    const auto turn = [](const Coefficients& terms, Coefficients& turned) {
        turned.count = terms.count;
        for (int m = 0; m < terms.count; ++m) turned.c[m] = -terms.c[m];
    };
    if (f.isCurved) [[unlikely]] {
        CurvedTerms<lines>& curve = out.makeCurved();
        curve.c1 = -f.curve.c1;
        eachLine<lines>([&](int i) { turn(f.curve.rises[i], curve.rises[i]); });
        curve.hammer = f.curve.hammer.negated();
    } else {
        out.isCurved = false;
    }
    out.length = f.length;
    out.c0 = -f.c0;
    eachLine<lines>([&](int i) { turn(f.decays[i], out.decays[i]); });
    out.wholeDecays = f.wholeDecays;
    out.rates = f.rates;
}

}  // namespace drillwave
