// SPDX-License-Identifier: GPL-3.0-or-later
// Incident and returning wave from what one gauge, or two along the rod, have seen.
#pragma once

#include <vector>

#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Share of a change between two samples that a front misses by: its time is known to a sample.
inline constexpr double frontError = 0.3;
/// Deviations of noise within which a change between two samples is no front.
inline constexpr double frontNoise = 5;

/// f and b at the gauge near the bit, sample by sample [N].
struct SeparatedWaves {
    std::vector<double> incident, returning;
};

/// Fits shift and gain of the far gauge on the first passage, from 20 µs before the front to 8 µs before the
/// reflection: both see f only.
void matchSecondGauge(PreparedRecord& record);

/// Separates signals of the gauges, those of the record or changes of them: one gauge in time, f until its
/// end and b after the reflection, two by
///
///     f1(t) = P2(t − θ) − P1(t − 2ϑ) + f1(t − 2ϑ),   b1 = P1 − f1        (theory of identification I1)
///
/// Linear in the signals. `transit` is ϑ.
SeparatedWaves separateWaves(const PreparedRecord& record,
                             const std::vector<const std::vector<double>*>& ofGauges, double transit);
/// The same of the record itself.
SeparatedWaves separateWaves(const PreparedRecord& record);

/// rms of what the second gauge sees otherwise than the first one on the first passage, beyond noise, share
/// of the peak.
double passageDifference(const PreparedRecord& record);

}  // namespace drillwave
