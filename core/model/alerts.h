// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks on a valid scenario.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

enum class AlertLevel { information, warning };

/// The code of the remark on a value outside its plausible range.
inline constexpr std::string_view implausibleValue = "outside_plausible_range";

/// A remark on a valid scenario (files §5.1).
struct Alert {
    AlertLevel level = AlertLevel::information;
    std::string code;       ///< "outside_plausible_range", "pulse_longer_than_round_trip", …
    std::string parameter;  ///< key, may be empty
    std::string text;       ///< one sentence
    bool operator==(const Alert&) const = default;
};

/// Values outside their plausible range, and assumptions of the model that the scenario strains.
std::vector<Alert> alertsFor(const Scenario& scenario);

}  // namespace drillwave
