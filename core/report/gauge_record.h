// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated record of strain gauges on rod or string for a computed blow, to rehearse the command `identify`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/blow/blow.h"

namespace drillwave {

/// Planned strain gauge: its column in the table and its position.
struct PlannedGauge {
    std::string column;   ///< name of the gauge's column in the table
    double distance = 0;  ///< distance from the bit face [m]; must be on a uniform section of rod or string
};

/// Sampling rate of the simulated record of strain gauges.
inline constexpr double gaugeRecordRate = 1e6;  ///< sampling rate [1/s]
/// Recorded time before time 0, when the blow reaches the struck end of the rod or string [s].
inline constexpr double gaugeRecordBegin = 3e-4;

/// Returns a table of `time [us]` and the strain of each gauge [microstrain], tension positive. Each sample
/// is the mean strain over its sampling interval. White noise from `seed` is added; its standard deviation is
/// `noise` (0 … 1) times the largest strain of the gauge. The record ends two round trips of a wave after the
/// blow reaches the bit, or earlier if the computed waves end. Requires a blow with units and histories
/// (Impact::hasHistories()), and a valid gaugePlace() for every gauge.
std::string gaugeRecordCsv(const Blow& blow, const std::vector<PlannedGauge>& gauges, double noise,
                           std::uint64_t seed);

}  // namespace drillwave
