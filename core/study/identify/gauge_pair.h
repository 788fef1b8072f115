// SPDX-License-Identifier: GPL-3.0-or-later
// Separation of the incident and the returning wave from the signals of one gauge, or of two along the rod.
#pragma once

#include <vector>

#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Assumed error of a sample at a wave front, as a share of the change from one sample to the next. The time
/// of a front is only known to within one sample.
inline constexpr double frontError = 0.3;
/// Smallest change between two samples that counts as a wave front, in standard deviations of the noise.
inline constexpr double frontNoise = 5;

/// Incident wave f and returning wave b at the gauge near the bit, one value per sample [N].
struct SeparatedWaves {
    std::vector<double> incident, returning;
};

/// Fits the time shift and the relative gain of the gauge far from the bit, and stores them in the record.
/// Uses the first passage of the blow, from 20 µs before the front to 8 µs before the reflection. In this
/// interval both gauges see only the incident wave f.
void matchSecondGauge(PreparedRecord& record);

/// Returns the incident wave f and the returning wave b that belong to signals of the gauges [N]. These are
/// the signals of the record, or changes of them such as noise.
/// With one gauge the waves are separated in time: f until its end, b after the reflection arrives. With two
/// gauges, P1 is the force near the bit, and P2 the force further away divided by its relative gain:
///
///     f1(t) = P2(t − θ) − P1(t − 2ϑ) + f1(t − 2ϑ),   b1 = P1 − f1        (theory of identification I1)
///
/// The result is linear in the signals. `transit` is the transit time ϑ between the gauges [s], θ the fitted
/// shift PreparedRecord::secondShift.
SeparatedWaves separateWaves(const PreparedRecord& record,
                             const std::vector<const std::vector<double>*>& ofGauges, double transit);
/// Returns the incident and the returning wave of a prepared record [N], computed with the signals and the
/// transit time of this record.
SeparatedWaves separateWaves(const PreparedRecord& record);

/// Returns the rms difference between the signals of the two gauges during the first passage of the blow, as
/// a share of the peak force. Noise is subtracted. Zero means that both gauges saw the same incident wave.
double passageDifference(const PreparedRecord& record);

}  // namespace drillwave
