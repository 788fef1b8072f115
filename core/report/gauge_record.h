// SPDX-License-Identifier: GPL-3.0-or-later
// The record that strain gauges on rod or string would make of a computed blow: a rehearsal of `identify`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/blow/blow.h"

namespace drillwave {

/// Name and place of a gauge that is planned.
struct PlannedGauge {
    std::string column;   ///< its name in the table
    double distance = 0;  ///< from the bit face [m], on a uniform section of rod or string
};

/// Samples in a second of such a record, and its time before the blow reaches the struck end.
inline constexpr double gaugeRecordRate = 1e6;    ///< [1/s]
inline constexpr double gaugeRecordBegin = 3e-4;  ///< [s]

/// Returns a table of `time [us]` and the strain of each gauge [microstrain], tension positive. Each sample
/// is the mean over its interval, with white noise from `seed` of the share `noise` (0 … 1) of the gauge's
/// largest strain. The record ends two round trips after the blow reaches the bit, or where the waves of a
/// string end. Requires a blow with units and histories (Impact::hasHistories()), and gaugePlace() of every
/// gauge.
std::string gaugeRecordCsv(const Blow& blow, const std::vector<PlannedGauge>& gauges, double noise,
                           std::uint64_t seed);

}  // namespace drillwave
