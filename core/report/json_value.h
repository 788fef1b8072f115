// SPDX-License-Identifier: GPL-3.0-or-later
// Values that several JSON reports hold.
#pragma once

#include <optional>
#include <string_view>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/text/json.h"
#include "core/text/units.h"

namespace drillwave {

/// The name of the SI unit of a quantity; "1" for a ratio.
Json unitJson(Quantity quantity);

/// beta, gamma, tau and delta.
JsonObject groupsJson(const Groups& groups);

/// The beginning that the JSON of all commands about a scenario has in common.
struct JsonHead {
    const Scenario& scenario;
    std::string_view scenarioText;            ///< gives the scenario again
    std::optional<MethodChoice> method = {};  ///< none where several methods are compared
    JsonObject units = {};                    ///< by parameter, output or key; left out where empty
    std::optional<double> runTime = {};       ///< wall clock time of the computation [s]
};

/// Returns `version`, `title`, `scenario`, `groups` and, as far as given, `method`, `segments`, `units` and
/// `run_time` (files §5).
JsonObject headJson(const JsonHead& head);

}  // namespace drillwave
