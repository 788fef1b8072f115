// SPDX-License-Identifier: GPL-3.0-or-later
// A range of a parameter, laid out evenly or by its logarithm.
#pragma once

namespace drillwave {

/// Range from `start` to `stop` (SI, start < stop; both > 0 if it is logarithmic). A share of the range is 0
/// at the start and 1 at the stop.
struct CurveRange {
    double start = 0;
    double stop = 1;
    enum class Spacing { linear, logarithmic } spacing = Spacing::linear;

    /// The value at a share of the way, 0 … 1; both ends exactly.
    double at(double share) const;
    /// The share of the way at which a value of the range lies.
    double shareOf(double value) const;
    /// Returns the change of the value per share of the range, at that value.
    double slopeAt(double value) const;
    bool operator==(const CurveRange&) const = default;
};

}  // namespace drillwave
