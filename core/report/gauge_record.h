// SPDX-License-Identifier: GPL-3.0-or-later
// The record that strain gauges on rod or string would make of a computed blow: a rehearsal of `identify`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/blow/blow.h"

namespace drillwave {

/// A gauge that is to be glued on.
struct PlannedGauge {
    std::string column;   ///< its name in the table
    double distance = 0;  ///< from the bit face [m], on a uniform section of rod or string
};

/// Samples in a second of such a record, and its time before the blow reaches the struck end.
inline constexpr double gaugeRecordRate = 1e6;    ///< [1/s]
inline constexpr double gaugeRecordBegin = 3e-4;  ///< [s]

/// Returns `time [us]` and for each gauge its strain [microstrain], tension positive, each the mean over a
/// sampling interval, with white noise of that share of the gauge's largest strain (0 … 1) from `seed`. Two
/// round trips behind the arrival of the blow at the bit, a string at most as long as it was followed.
/// Requires a blow with units and histories (Impact::hasHistories()), and gaugePlace() of every gauge.
std::string gaugeRecordCsv(const Blow& blow, const std::vector<PlannedGauge>& gauges, double noise,
                           std::uint64_t seed);

}  // namespace drillwave
