// SPDX-License-Identifier: GPL-3.0-or-later
// Quality of a record: flat tops, offset, drift, steps, jitter, several blows, opposite gauges.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/signal/samples.h"
#include "core/text/message.h"

namespace drillwave {

/// Shares are those of the largest value over the zero line, in size.
struct SignalQuality {
    double zero = 0;                    ///< mean before the front, as in the table
    double peak = 0;                    ///< largest value less that, as in the table, with its sign
    std::optional<double> offset = {};  ///< share; nothing where fewer than 50 samples are quiet before it
    std::optional<double> drift = {};   ///< share in a millisecond, where it is more than noise
    double noise = 0;                   ///< deviation before the front, share
    double step = 0;                    ///< of the recorder, share; 0 where none is seen
    bool isQuantised = false;           ///< the noise does not carry the value between the steps
    std::size_t flatSamples = 0;        ///< equal ones in a row at the largest value
    double flatTop = 0;                 ///< that value as in the table
    bool isClipped = false;             ///< more of them than the noise leaves equal
    double jitter = 0;       ///< largest difference of a step of time from the usual one, share of it
    bool hasJitter = false;  ///< times are those of a clock and not even to 2 %
    double gap = 0;          ///< longest pause in the clock [s]; 0 where there is none
    std::size_t blows = 1;   ///< fronts after a quiet millisecond
    std::optional<double> gaugeDifference = {};  ///< rms of half the difference of opposite gauges, share
};

/// Requires samples without a problem. Thresholds: theory of identification, section 2.
SignalQuality signalQuality(const Samples& samples);

/// A remark by its code ("clipped") and as a sentence.
struct SignalRemark {
    std::string code;
    Message text;
};

/// Remarks on quality in the order of `SignalQuality`; the sentences name times of the table.
std::vector<SignalRemark> qualityRemarks(const SignalQuality& quality, const Samples& samples);

}  // namespace drillwave
