// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of a record on even times, its blows apart, and what the recorder did to them.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/study/identify/identify_question.h"

namespace drillwave {

/// Samples of all gauges at even times.
struct EvenSamples {
    double start = 0;                              ///< time of the first sample [s]
    double step = 0;                               ///< [s]
    std::vector<std::vector<double>> force;        ///< of each gauge [N]
    std::vector<std::vector<double>> opposite;     ///< of each gauge; empty where it is no pair
    std::vector<double> recorderStep;              ///< of each gauge, smallest difference between values [N]
    std::vector<std::vector<bool>> isClipped;      ///< of each gauge; empty: none
    std::vector<bool> isMissing;                   ///< interpolated across a pause; empty: none
    std::optional<std::pair<double, double>> gap;  ///< first pause of more than 20 steps, from and to [s]
    std::size_t count() const { return force.front().size(); }
};

/// Returns the samples at steps of the median of the times; interpolated where steps differ by more than
/// 2 %. Samples closer than 0.45 µs are averaged. Requires at least two samples.
EvenSamples evenSamples(const GaugeRecord& record);

/// Level and noise of samples before a front, and the front.
struct FrontFound {
    std::size_t front = 0;
    double zero = 0, deviation = 0;
    double peak = 0;  ///< largest value less the zero, in size
    bool isFound = false;
};
/// The first sample in [from, to) beyond six deviations and 5 % of the peak.
FrontFound findFront(const std::vector<double>& force, std::size_t from, std::size_t to, double step);

/// Begin and end of each blow in samples: a front of 30 % of the peak after a quiet millisecond begins
/// another. At least one.
std::vector<std::pair<std::size_t, std::size_t>> blowRanges(const std::vector<double>& force, double step);

/// The value between samples by a cubic through four of them; 0 outside.
double sampleAt(const std::vector<double>& samples, double place);

/// Smooths samples by a Gaussian of this deviation [s]; at the ends by what there is of it.
void smoothSamples(std::vector<double>& values, double step, double deviation);

}  // namespace drillwave
