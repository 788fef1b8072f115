// SPDX-License-Identifier: GPL-3.0-or-later
// Quality of a record: clipping, offset, drift, resolution, jitter, several blows, differing gauges.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/signal/samples.h"
#include "core/text/message.h"

namespace drillwave {

/// Quality of a record. Shares are relative to `peak`, the largest deviation from the zero line.
struct SignalQuality {
    /// Zero line, the mean value before the blow, in the unit of the table. It is 0 if fewer than 50 samples
    /// are before the blow.
    double zero = 0;
    /// Largest deviation from the zero line, in the unit of the table, with its sign.
    double peak = 0;
    /// Zero line, the mean value before the blow, as a share of the peak; nullopt if fewer than 50 samples
    /// are before the blow.
    std::optional<double> offset = {};
    /// Drift of the signal without load: change of its mean value in 1 ms, as a share of the peak. It is
    /// nullopt if the change does not exceed the noise.
    std::optional<double> drift = {};
    double noise = 0;  ///< standard deviation before the blow, as a share of the peak
    /// Resolution of the recorder: step between two neighbouring values that it can record, as a share of
    /// the peak. It is 0 if no such steps are found.
    double step = 0;
    /// Whether the resolution is coarser than the noise, so that averaging cannot improve it.
    bool isQuantised = false;
    std::size_t flatSamples = 0;  ///< number of equal samples in a row at the largest value
    double flatTop = 0;           ///< value of the largest run of equal samples, in the unit of the table
    /// Whether the record is probably clipped: more samples are equal to its largest or smallest value than
    /// noise allows.
    bool isClipped = false;
    /// Largest deviation of a time step from the usual (median) step, as a share of that step. Steps far from
    /// it, such as pauses, do not count.
    double jitter = 0;
    bool hasJitter = false;  ///< whether the times are from a clock whose steps vary by more than 2 %
    double gap = 0;          ///< longest pause in the times [s]; 0 if there is none
    std::size_t blows = 1;   ///< number of blows: steep rises after at least 1 ms without a signal
    /// Measure of bending: root mean square of half the difference between opposite gauges, as a share of
    /// the peak. Empty with only one gauge.
    std::optional<double> gaugeDifference = {};
};

/// Returns the quality of a record. Requires samples without a problem. The thresholds above which a record
/// counts as clipped, noisy or drifting are in the theory of identification, section 2.
SignalQuality signalQuality(const Samples& samples);

/// Remark on the quality of a record: its code ("clipped") and a sentence.
struct SignalRemark {
    std::string code;
    Message text;
};

/// Returns the remarks on the quality of a record, in the order of the members of SignalQuality. Times in the
/// sentences are those of the table.
std::vector<SignalRemark> qualityRemarks(const SignalQuality& quality, const Samples& samples);

}  // namespace drillwave
