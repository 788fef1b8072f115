// SPDX-License-Identifier: GPL-3.0-or-later
// Power series given by their coefficients.
#pragma once

#include <initializer_list>

#include "core/numeric/power_series.h"

namespace drillwave::test {

/// Returns the series Σ c_k u^k with u = x/length, on 0 ≤ x ≤ length.
inline PowerSeries<double> series(double length, std::initializer_list<double> coefficients) {
    auto f = PowerSeries<double>::zero(length);
    for (const double c : coefficients) f.c[f.count++] = c;
    return f;
}

}  // namespace drillwave::test
