// SPDX-License-Identifier: GPL-3.0-or-later
// Parameter range with linear or logarithmic spacing.
#pragma once

namespace drillwave {

/// Range of a parameter from `start` to `stop`, in SI units, with start < stop. Both must be > 0 for
/// logarithmic spacing. A position in the range is given as a share: 0 at the start, 1 at the stop.
struct CurveRange {
    double start = 0;
    double stop = 1;
    enum class Spacing { linear, logarithmic } spacing = Spacing::linear;

    /// Returns the parameter value at a share 0 … 1 of the range. Shares 0 and 1 give exactly `start` and
    /// `stop`.
    double at(double share) const;
    /// Returns the share of the range, 0 … 1, at which a parameter value lies.
    double shareOf(double value) const;
    /// Returns the derivative of the parameter value with respect to the share of the range, at the parameter
    /// value `value`. It converts errors of a share into errors of the parameter.
    double slopeAt(double value) const;
    bool operator==(const CurveRange&) const = default;
};

}  // namespace drillwave
