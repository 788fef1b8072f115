// SPDX-License-Identifier: GPL-3.0-or-later
// One blow for programs.
#pragma once

#include <string>

#include "core/blow/blow.h"
#include "core/blow/outputs.h"
#include "core/text/json.h"

namespace drillwave {

/// Returns a value of an output in SI units; energies given as shares of the hammer energy are in J.
double inSi(const Output& output, double value, const Blow& blow);

/// The JSON objects of alerts: level, code, parameter, text.
JsonArray alertsJson(const std::vector<Alert>& alerts);

/// The JSON object of a blow (files §5): results dimensionless and, where the scenario has units, in SI with
/// the unit of each; and the scenario as the text that gives them again (completeScenarioText()). Numbers
/// read back exactly; they are null where the case could not be solved. Requires Detail::ledger or more.
std::string blowJson(const Blow& blow, const std::string& scenarioText);

}  // namespace drillwave
