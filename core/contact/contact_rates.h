// SPDX-License-Identifier: GPL-3.0-or-later
// The slopes of the two lines of the law, which are the rates of a blow.
#pragma once

namespace drillwave {

/// F = aU + const. along a line, and so F' = a(2g − F), per t0 (T16): a = β in primary loading, β/γ on the
/// elastic line.
template <class Real>
struct ContactRates {
    Real primary = 0;
    Real elastic = 0;
};

}  // namespace drillwave
