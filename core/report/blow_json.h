// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of one blow, for other programs.
#pragma once

#include <string>

#include "core/blow/blow.h"
#include "core/blow/outputs.h"
#include "core/text/json.h"

namespace drillwave {

/// Returns the value of an output in SI units. An energy given as a share of the hammer energy is converted
/// to joules.
double inSi(const Output& output, double value, const Blow& blow);

/// Returns alerts as an array of JSON objects with the members level, code, parameter and text.
JsonArray alertsJson(const std::vector<Alert>& alerts);

/// Returns a blow as a JSON object (files §5). Results are dimensionless and, if the scenario has units, also
/// in SI units with their names. The object contains `scenarioText`, from completeScenarioText(), with which
/// the results can be reproduced. Numbers are written with all digits; they are null if the blow was not
/// solved. Requires a blow solved with Detail::ledger (sums that check the balances) or more.
std::string blowJson(const Blow& blow, const std::string& scenarioText);

}  // namespace drillwave
