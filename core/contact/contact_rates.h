// SPDX-License-Identifier: GPL-3.0-or-later
// The two rates of a blow.
#pragma once

namespace drillwave {

/// F' = a(2g − F) in contact, per t0: a = β in primary loading, β/γ on the elastic line.
template <class Real>
struct ContactRates {
    Real primary = 0;
    Real elastic = 0;
};

}  // namespace drillwave
