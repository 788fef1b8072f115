// SPDX-License-Identifier: GPL-3.0-or-later
// Separation of the incident and the returning wave from the signals of one gauge, or of two along the rod.
#pragma once

#include <vector>

#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Error of a sample at a front, as a share of the change between two samples. It arises because the time of
/// the front is known only to a sample.
inline constexpr double frontError = 0.3;
/// Number of noise standard deviations below which a change between two samples is not a front.
inline constexpr double frontNoise = 5;

/// Incident wave f and returning wave b at the gauge near the bit, one value per sample [N].
struct SeparatedWaves {
    std::vector<double> incident, returning;
};

/// Fits the time shift and relative gain of the far gauge and stores them in the record. Uses the first
/// passage of the blow, from 20 µs before the front to 8 µs before the reflection. In this interval both
/// gauges see only the incident wave f.
void matchSecondGauge(PreparedRecord& record);

/// Returns the incident wave f and the returning wave b from signals of the gauges [N]: those of the record,
/// or changes of them.
/// With one gauge the waves are separated in time: f until its end, b after the reflection arrives. With two
/// gauges, P1 near the bit and P2 further away:
///
///     f1(t) = P2(t − θ) − P1(t − 2ϑ) + f1(t − 2ϑ),   b1 = P1 − f1        (theory of identification I1)
///
/// The result is linear in the signals. `transit` is the transit time ϑ between the gauges [s], θ the fitted
/// shift PreparedRecord::secondShift.
SeparatedWaves separateWaves(const PreparedRecord& record,
                             const std::vector<const std::vector<double>*>& ofGauges, double transit);
/// Returns the incident and the returning wave of the record itself [N], with its own transit time.
SeparatedWaves separateWaves(const PreparedRecord& record);

/// Returns the rms difference between the two gauges during the first passage, beyond noise, as a share of
/// the peak force. Zero means that both saw the same incident wave.
double passageDifference(const PreparedRecord& record);

}  // namespace drillwave
