// SPDX-License-Identifier: GPL-3.0-or-later
// Values that several JSON reports hold.
#pragma once

#include "core/model/scenario.h"
#include "core/text/json.h"
#include "core/text/units.h"

namespace drillwave {

/// The name of the SI unit of a quantity; "1" for a ratio.
Json unitJson(Quantity quantity);

/// beta, gamma, tau and delta.
JsonObject groupsJson(const Groups& groups);

}  // namespace drillwave
