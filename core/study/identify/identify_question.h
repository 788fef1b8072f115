// SPDX-License-Identifier: GPL-3.0-or-later
// Input of an identification: a scenario, records of strain gauges, and tolerances of known values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

/// Recorded signal of one gauge, or of two gauges on opposite sides of the rod.
struct GaugeChannel {
    std::string name;     ///< name of the channel, such as "near"; "top+bottom" for a pair
    double distance = 0;  ///< distance from the bit face [m], > 0
    /// Force at the gauge [N], for a pair the mean of both. Compression may have either sign.
    std::vector<double> force;
    /// Half the difference between the two gauges of a pair on opposite sides of the rod (bending) [N]; empty
    /// for a single gauge.
    std::vector<double> opposite;
};

/// Samples of one recording, which may contain several blows.
struct GaugeRecord {
    std::string file;                  ///< name of the file, for messages
    std::vector<double> time;          ///< sample times [s], increasing
    std::vector<GaugeChannel> gauges;  ///< signals of one or two gauges along the rod
    std::vector<double> behind;  ///< force in the bar behind the specimen [N]; empty if it was not recorded
};

/// Rock law to fit to the records.
enum class LawChoice {
    automatic,  ///< bilinear law, or one with a corner if the record requires it
    bilinear,
    corner,
    file,  ///< law of the scenario file; only its timing is fitted
};

/// Treatment of wave dispersion in round bars.
enum class DispersionChoice {
    fit,   ///< the share of the dispersion is fitted
    bar,   ///< full dispersion of a round bar
    none,  ///< no dispersion (plane waves)
};

/// 95 % tolerance of a value that the record cannot determine, as given by option --known.
struct KnownTolerance {
    /// Key of the value: "gain" (amplifier), "zero" (zero line), "gauge" (position), "rod.diameter",
    /// "string.bit_head.length", …
    std::string key;
    /// Tolerance > 0. It is relative for the keys "gain" and "zero", in [m] for "gauge", otherwise in the SI
    /// unit of the parameter.
    double tolerance = 0;
    bool operator==(const KnownTolerance&) const = default;
};

struct IdentifyQuestion {
    Scenario scenario;
    std::vector<GaugeRecord> records;
    LawChoice law = LawChoice::automatic;
    DispersionChoice dispersion = DispersionChoice::fit;
    bool barBehind = false;  ///< whether the rock is a specimen between two long, identical bars
    bool allBlows = false;   ///< whether every blow in a record is evaluated; otherwise only the first
    /// End of the evaluated time window, measured from the arrival of the reflection [s]; empty for the
    /// default.
    std::optional<double> end;
    std::vector<KnownTolerance> known;
    std::uint64_t seed = 1;
    /// Distance [m] from the specimen to the gauge on the second bar behind it; empty if there is no such
    /// gauge.
    std::optional<double> checkDistance;
};

}  // namespace drillwave
