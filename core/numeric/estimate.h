// SPDX-License-Identifier: GPL-3.0-or-later
// A number with what is known about its error.
#pragma once

namespace drillwave {

/// Number with a bound on its error, as estimated from the accuracy of its computation.
struct Estimate {
    double value = 0;
    double error = 0;
    bool operator==(const Estimate&) const = default;
};

}  // namespace drillwave
