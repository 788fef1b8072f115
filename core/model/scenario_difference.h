// SPDX-License-Identifier: GPL-3.0-or-later
// In which parameters scenarios differ.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/model/parameter.h"

namespace drillwave {

/// The value in SI of a parameter; nothing where it does not apply or is not given.
std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter);

/// The parameters that at least one of the scenarios gives (isGiven()) and that have not the same value in
/// all of them, in the order of the table, and of sections after it by place. What only follows from others,
/// such as the groups of a scenario in physical units, is not among them.
std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios);

}  // namespace drillwave
