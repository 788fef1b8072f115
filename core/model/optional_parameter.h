// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that a scenario may leave open.
#pragma once

#include <optional>
#include <string_view>

#include "core/model/scenario.h"

namespace drillwave {

/// The member behind an optional parameter ("drill.thrust"), to be reset to "not given"; nullptr for the key
/// of any other parameter.
std::optional<double>* optionalValue(Scenario& scenario, std::string_view key);

}  // namespace drillwave
