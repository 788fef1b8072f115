// SPDX-License-Identifier: GPL-3.0-or-later
// Resampling of a record to equal time steps, division into blows, and detection of clipped or missing
// samples.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/study/identify/identify_question.h"

namespace drillwave {

/// Samples of all gauges of a record at equal time steps.
struct EvenSamples {
    double start = 0;                        ///< time of the first sample [s]
    double step = 0;                         ///< time between samples [s]
    std::vector<std::vector<double>> force;  ///< force of each gauge, indexed [gauge][sample] [N]
    /// Half the difference between the two gauges of a pair on opposite sides of the rod (bending) [N],
    /// indexed [gauge][sample]; empty for a single gauge.
    std::vector<std::vector<double>> opposite;
    /// Resolution of the recorder: smallest difference between two recorded values of each gauge [N].
    std::vector<double> recorderStep;
    /// Whether each sample is clipped, indexed [gauge][sample]; empty for a gauge without clipped samples.
    std::vector<std::vector<bool>> isClipped;
    /// Whether each sample is interpolated across a pause of the recording; empty if none is.
    std::vector<bool> isMissing;
    /// Start and end [s] of the first pause of the recording that is longer than 20 time steps; empty if
    /// there is none.
    std::optional<std::pair<double, double>> gap;
    std::size_t count() const { return force.front().size(); }
};

/// Returns the samples of a record at equal time steps, the median of the recorded ones. If recorded steps
/// differ by more than 2 %, values are interpolated at about the mean step. Samples closer than 0.45 µs are
/// averaged. Requires at least two samples.
EvenSamples evenSamples(const GaugeRecord& record);

/// Front of a blow in a record (index of its first sample), with zero level and noise of the samples before
/// it.
struct FrontFound {
    std::size_t front = 0;
    double zero = 0, deviation = 0;
    double peak = 0;  ///< largest deviation from the zero level, as an absolute value [N]
    bool isFound = false;
};
/// Returns the front of the blow: the first sample in [from, to) that clearly differs from the zero level.
/// The difference must exceed six standard deviations of the noise and 5 % of the peak. `step` is the time
/// between samples [s].
FrontFound findFront(const std::vector<double>& force, std::size_t from, std::size_t to, double step);

/// Returns the sample ranges [begin, end) of the blows in a record, at least one. A further blow begins if
/// the force exceeds 30 % of the first peak after at least 1 ms of quiet.
std::vector<std::pair<std::size_t, std::size_t>> blowRanges(const std::vector<double>& force, double step);

/// Returns the value at a fractional sample index `place`, interpolated by a cubic through four samples.
/// Samples outside the record count as 0.
double sampleAt(const std::vector<double>& samples, double place);

/// Smooths samples in place by a Gaussian with the standard deviation `deviation` [s]. `step` is the time
/// between samples [s]. At both ends of the samples, the Gaussian is truncated.
void smoothSamples(std::vector<double>& values, double step, double deviation);

}  // namespace drillwave
