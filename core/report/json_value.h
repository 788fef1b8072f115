// SPDX-License-Identifier: GPL-3.0-or-later
// JSON values that several reports have in common.
#pragma once

#include <optional>
#include <string_view>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/text/json.h"
#include "core/text/units.h"

namespace drillwave {

/// Returns the name of the SI unit of a quantity as JSON; "1" for a ratio.
Json unitJson(Quantity quantity);

/// Returns a JSON object with the dimensionless groups beta, gamma, tau and delta.
JsonObject groupsJson(const Groups& groups);

/// Data for the first members of the JSON of every command that takes a scenario, such as the scenario text
/// and the method.
struct JsonHead {
    const Scenario& scenario;
    std::string_view scenarioText;            ///< scenario file that reproduces the scenario
    std::optional<MethodChoice> method = {};  ///< method used; empty if several methods are compared
    JsonObject units = {};  ///< units by parameter, output or key; omitted from the JSON if empty
    std::optional<double> runTime = {};  ///< elapsed computing time [s]
};

/// Returns a JSON object with the members `version`, `outputs`, `title`, `scenario` and `groups` (files §5).
/// `method`, `segments`, `units` and `run_time` follow if they are given.
JsonObject headJson(const JsonHead& head);

}  // namespace drillwave
