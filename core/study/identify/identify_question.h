// SPDX-License-Identifier: GPL-3.0-or-later
// Input of an identification: a scenario, records of strain gauges, and what is known about them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

/// One gauge, or two on opposite sides, as recorded.
struct GaugeChannel {
    std::string name;              ///< "near", "top+bottom"
    double distance = 0;           ///< from the bit face [m], > 0
    std::vector<double> force;     ///< [N], of a pair the mean; either sign may be compression
    std::vector<double> opposite;  ///< half the difference of a pair [N]; else empty
};

/// Samples of one recording.
struct GaugeRecord {
    std::string file;                  ///< for messages
    std::vector<double> time;          ///< [s], increasing
    std::vector<GaugeChannel> gauges;  ///< one or two
    std::vector<double> behind;        ///< force in the bar behind the specimen [N], or empty
};

/// Law that is fitted.
enum class LawChoice {
    automatic,  ///< bilinear, or one corner where the record asks for it
    bilinear,
    corner,
    file,  ///< that of the scenario: nothing is fitted but the timing
};

/// Share of the dispersion of a round bar that is taken into account.
enum class DispersionChoice {
    fit,   ///< an unknown
    bar,   ///< all of it
    none,  ///< plane waves
};

/// 95 % tolerance of a value that the record does not give.
struct KnownTolerance {
    std::string key;       ///< "gain", "zero", "gauge", "rod.diameter", "string.bit_head.length"
    double tolerance = 0;  ///< > 0; relative for gain and zero, [m] for gauge, else as the parameter
    bool operator==(const KnownTolerance&) const = default;
};

struct IdentifyQuestion {
    Scenario scenario;
    std::vector<GaugeRecord> records;
    LawChoice law = LawChoice::automatic;
    DispersionChoice dispersion = DispersionChoice::fit;
    bool barBehind = false;     ///< a specimen between two long, like bars
    bool allBlows = false;      ///< each front of a record is a record of its own
    std::optional<double> end;  ///< of the window after the reflection arrives [s]
    std::vector<KnownTolerance> known;
    std::uint64_t seed = 1;
    std::optional<double> checkDistance;  ///< of the gauge on the bar behind from the specimen [m]
};

}  // namespace drillwave
