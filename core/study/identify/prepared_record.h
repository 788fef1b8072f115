// SPDX-License-Identifier: GPL-3.0-or-later
// A record on even times with zero level, front and arrival, ready to be fitted, or why it cannot be.
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

/// One gauge of a prepared record.
struct PreparedGauge {
    std::vector<double> force;     ///< compression positive, zero level taken off [N]
    std::vector<double> opposite;  ///< half the difference of a pair, its own zero off [N]
    GaugeNoise noise;
    double zero = 0;          ///< level taken off, as recorded [N]
    double recorderStep = 0;  ///< q, smallest difference between two values [N]
};

/// A record before a law is fitted. Times are from the front at the gauge near the bit; sample i is at
/// (i − front) step.
struct PreparedRecord {
    double step = 0;                    ///< h [s]
    std::size_t front = 0;              ///< sample at which the front reaches the gauge near the bit
    std::size_t quiet = 0;              ///< samples of zero, from the first one
    double startTime = 0;               ///< time of the record at the front [s]
    double peak = 0;                    ///< of the incident wave [N]
    int sign = 1;                       ///< −1: the record had compression negative
    std::vector<PreparedGauge> gauges;  ///< the one near the bit first
    std::vector<GaugePlace> places;     ///< of the gauges
    double roundTrip = 0;               ///< D0 = 2a/c by the file [s]
    double arrival = 0;                 ///< of the reflection as seen [s]; 0 where it was not looked for
    double shift = 0;                   ///< D0 is moved by that to the arrival seen [s]
    double incidentEnd = 0;             ///< end of f [s]
    double quietFrom = 0;               ///< begin of the quiet stretch [s]; of one gauge
    double end = 0;                     ///< of the window [s]
    double before = 0;                  ///< A_pre, waves before the front, share of the peak
    double bending = 0;                 ///< rms of half the difference of a pair, share of the peak
    std::vector<bool> isLost;           ///< samples of the near gauge, clipped or missing; empty: none
    double transit = 0;                 ///< ϑ between two gauges [s]
    double secondShift = 0;             ///< θ of the far gauge [s]
    double secondGain = 1;              ///< of the far gauge relative to the near one
    std::size_t furtherBlows = 0;
    std::vector<std::string> remarks;  ///< codes

    bool isPair() const { return gauges.size() == 2; }
    std::size_t count() const { return gauges.front().force.size(); }
    double timeOf(std::size_t sample) const {
        return (static_cast<double>(sample) - static_cast<double>(front)) * step;
    }
    /// Round trip between gauge and rock: D0 and the sections towards the bit [s].
    double roundTripToRock() const { return roundTrip + 2 * places.front().end.transitTime(); }
};

/// Why a record says nothing about the rock (theory of identification §3).
struct RecordRefusal {
    std::string code;  ///< "no_front", "short_zero", "gap", "blow_not_over", "too_short", "clipped", …
    Message text;      ///< what is wrong and what to change at the rig
};

struct Preparation {
    PreparedRecord record;
    std::optional<RecordRefusal> refusal;
};

/// Where the reflection is expected.
enum class ArrivalChoice {
    seen,    ///< where it is seen, where that is not where the file has it
    ofFile,  ///< by the distance of the file
};

/// Prepares a record. `blow` counts the fronts of the record, from 0.
Preparation prepareRecord(const GaugeRecord& record, const std::vector<GaugePlace>& places,
                          const IdentifyQuestion& question, std::size_t blow = 0,
                          ArrivalChoice arrival = ArrivalChoice::seen);

/// 95 % tolerance of a place of a gauge [m].
double placeTolerance(const IdentifyQuestion& question);

}  // namespace drillwave
