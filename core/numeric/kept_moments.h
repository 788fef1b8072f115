// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of a power series that are kept when another takes its place.
#pragma once

#include <algorithm>
#include <array>

#include "core/numeric/power_series.h"

namespace drillwave {

/// How many moments are kept: ∫ f xʲ for j = 0 … 3.
inline constexpr int keptMoments = 4;

/// Adds to `f`, given on the scale of its length, the polynomial of third degree that has the moments of
/// `deviation`: a function on the part [from, from + share] of that interval, both in lengths of f. It is the
/// expansion of the deviation in Legendre polynomials of the whole interval, cut off behind the kept moments.
template <class Real>
void addMoments(PowerSeries<Real>& f, const PowerSeries<Real>& deviation, Real from, Real share) {
    std::array<Real, keptMoments> own;  // ∫ d vʲ dv over the part itself, 0 ≤ v ≤ 1
    for (int j = 0; j < keptMoments; ++j) {
        Real sum = 0;
        for (int k = deviation.count - 1; k >= 0; --k) sum += deviation.c[k] / Real(k + j + 1);
        own[j] = sum;
    }
    // ∫ d uʲ du over the whole interval, u = from + share v
    const std::array<Real, keptMoments> moments{
        share * own[0], share * (from * own[0] + share * own[1]),
        share * (from * from * own[0] + 2 * from * share * own[1] + share * share * own[2]),
        share * (from * from * from * own[0] + 3 * from * share * (from * own[1] + share * own[2]) +
                 share * share * share * own[3])};
    static constexpr int legendre[keptMoments][keptMoments] = {// on [0, 1], Pₙ(1) = 1
                                                               {1, 0, 0, 0},
                                                               {-1, 2, 0, 0},
                                                               {1, -6, 6, 0},
                                                               {-1, 12, -30, 20}};
    for (int k = f.count; k < keptMoments; ++k) f.c[k] = 0;
    f.count = std::max(f.count, keptMoments);
    for (int n = 0; n < keptMoments; ++n) {
        Real share_n = 0;
        for (int j = 0; j <= n; ++j) share_n += Real(legendre[n][j]) * moments[j];
        share_n *= Real(2 * n + 1);
        for (int j = 0; j <= n; ++j) f.c[j] += share_n * Real(legendre[n][j]);
    }
}

}  // namespace drillwave
