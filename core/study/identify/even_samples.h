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
    /// Half the difference of a gauge pair, indexed [gauge][sample] [N]; empty for a single gauge.
    std::vector<std::vector<double>> opposite;
    /// Smallest difference between two recorded values of each gauge [N].
    std::vector<double> recorderStep;
    /// Whether a sample is clipped, indexed [gauge][sample]; empty for a gauge without clipping.
    std::vector<std::vector<bool>> isClipped;
    /// Whether a sample is interpolated across a pause of the recording; empty if none is.
    std::vector<bool> isMissing;
    /// Start and end [s] of the first pause of more than 20 steps; empty if there is none.
    std::optional<std::pair<double, double>> gap;
    std::size_t count() const { return force.front().size(); }
};

/// Returns the samples of a record at equal steps, whose length is the median of the recorded steps. Values
/// are interpolated if steps differ by more than 2 %. Samples closer than 0.45 µs are averaged. Requires at
/// least two samples.
EvenSamples evenSamples(const GaugeRecord& record);

/// Front of a blow in a record, with the zero level and the noise of the samples before it.
struct FrontFound {
    std::size_t front = 0;
    double zero = 0, deviation = 0;
    double peak = 0;  ///< largest deviation from the zero level, as an absolute value [N]
    bool isFound = false;
};
/// Returns the front: the first sample in [from, to) far from the zero level. It differs by more than six
/// standard deviations and 5 % of the peak. `step` is the time between samples [s].
FrontFound findFront(const std::vector<double>& force, std::size_t from, std::size_t to, double step);

/// Returns the sample ranges [begin, end) of the blows of a record, at least one. A blow begins where the
/// force rises above 30 % of the peak after at least 1 ms of quiet.
std::vector<std::pair<std::size_t, std::size_t>> blowRanges(const std::vector<double>& force, double step);

/// Returns the value at a fractional sample index `place`, by a cubic through four samples; 0 outside the
/// samples.
double sampleAt(const std::vector<double>& samples, double place);

/// Smooths samples in place by a Gaussian with a standard deviation [s]. At the ends, the Gaussian is
/// truncated.
void smoothSamples(std::vector<double>& values, double step, double deviation);

}  // namespace drillwave
