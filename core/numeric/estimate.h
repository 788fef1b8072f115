// SPDX-License-Identifier: GPL-3.0-or-later
// Number with a bound on its error.
#pragma once

namespace drillwave {

/// Number with a bound on its absolute error in the same unit, estimated from the accuracy of the
/// computation.
struct Estimate {
    double value = 0;
    double error = 0;
    bool operator==(const Estimate&) const = default;
};

}  // namespace drillwave
