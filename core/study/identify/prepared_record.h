// SPDX-License-Identifier: GPL-3.0-or-later
// Record prepared for a fit, with equal time steps, zero level, front and arrival time; or the reason why it
// cannot be used.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/study/identify/gauge_noise.h"
#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_question.h"
#include "core/text/message.h"

namespace drillwave {

/// Signal of one gauge in a record prepared for a fit.
struct PreparedGauge {
    std::vector<double> force;  ///< force [N], compression positive, zero level subtracted
    /// Half the difference between two gauges on opposite sides of the rod (bending) [N], minus its zero
    /// level; empty for a single gauge.
    std::vector<double> opposite;
    GaugeNoise noise;
    double zero = 0;          ///< zero level that was subtracted [N], with the sign of the recording
    double recorderStep = 0;  ///< q, smallest difference between two recorded values [N]
};

/// Record prepared for fitting a rock law. Time 0 is the arrival of the front at the gauge near the bit;
/// sample i is at time (i − front)·step.
struct PreparedRecord {
    double step = 0;        ///< h, the time between samples [s]
    std::size_t front = 0;  ///< index of the sample at which the front reaches the gauge near the bit
    std::size_t quiet = 0;  ///< number of samples, from the first one, that define the zero level
    double startTime = 0;   ///< time of the front on the time axis of the original recording [s]
    double peak = 0;        ///< peak force of the incident wave [N]
    int sign = 1;           ///< sign of compression in the original recording: +1 or −1
    std::vector<PreparedGauge> gauges;  ///< signals of the gauges, the one near the bit first
    std::vector<GaugePlace> places;     ///< positions of the gauges, in the same order
    /// D0 = 2a/c [s]: round-trip time from the gauge near the bit to the end of the gauge's section,
    /// according to the scenario file.
    double roundTrip = 0;
    /// Arrival time of the reflection as seen in the record [s]; 0 if it was not searched for or not found.
    double arrival = 0;
    /// Correction added to the round-trip time D0 (see `roundTrip`), so that it agrees with the observed
    /// arrival of the reflection [s].
    double shift = 0;
    /// Scale of the rock gaps that a fit tries, usually 1. If the unit of the record is doubtful, it is the
    /// factor by which forces are probably wrong, and therefore the gap too.
    double gapScale = 1;
    double incidentEnd = 0;  ///< time at which the incident wave f ends [s]
    /// Time after which the gauge shows no more of the blow until the reflection arrives [s]; only used with
    /// one gauge.
    double quietFrom = 0;
    double end = 0;      ///< end of the evaluated window [s]
    double before = 0;   ///< A_pre, amplitude of waves before the front, as a share of the peak force
    double bending = 0;  ///< rms of half the difference of a gauge pair, as a share of the peak force
    /// Whether each sample of the gauge near the bit is clipped or missing; empty if none is.
    std::vector<bool> isLost;
    double transit = 0;      ///< transit time ϑ between two gauges [s]
    double secondShift = 0;  ///< fitted delay θ of the front from the far to the near gauge [s]
    double secondGain = 1;   ///< gain of the far gauge relative to the near one
    std::size_t furtherBlows = 0;
    std::vector<std::string> remarks;  ///< codes of warnings about the record, such as "clipped"

    bool isPair() const { return gauges.size() == 2; }
    std::size_t count() const { return gauges.front().force.size(); }
    double timeOf(std::size_t sample) const {
        return (static_cast<double>(sample) - static_cast<double>(front)) * step;
    }
    /// Returns the round-trip time of a wave between gauge and rock [s]. It is `roundTrip` plus twice the
    /// transit time of the sections towards the bit.
    double roundTripToRock() const { return roundTrip + 2 * places.front().end.transitTime(); }
};

/// Reason why a record of strain gauges cannot be used to identify the rock (theory of identification §3).
struct RecordRefusal {
    /// Code of the reason: "no_front", "short_zero", "gap", "blow_not_over", "too_short", "clipped", …
    std::string code;
    Message text;  ///< explanation of what is wrong and what to change at the rig
};

struct Preparation {
    PreparedRecord record;
    std::optional<RecordRefusal> refusal;
};

/// Choice of the time at which the reflection is expected.
enum class ArrivalChoice {
    seen,    ///< time observed in the record, if it differs from that of the scenario file
    ofFile,  ///< time computed from the gauge distance in the scenario file
};

/// Returns one blow of a record (index from 0), prepared for fitting a rock law, or the reason why it cannot
/// be used.
Preparation prepareRecord(const GaugeRecord& record, const std::vector<GaugePlace>& places,
                          const IdentifyQuestion& question, std::size_t blow = 0,
                          ArrivalChoice arrival = ArrivalChoice::seen);

/// Returns the 95 % tolerance of a gauge position [m].
double placeTolerance(const IdentifyQuestion& question);

}  // namespace drillwave
