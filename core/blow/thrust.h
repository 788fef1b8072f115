// SPDX-License-Identifier: GPL-3.0-or-later
// The feed force that blows need for full penetration.
#pragma once

#include <optional>
#include <string>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Mean thrust f·I0·(1 + e) [N] (T34) [paper (9)]: the impulse that the rock gives back with every blow that
/// begins at rest on the rock. Of a drill string (strings §7) I0 is what its hammer hands on, `transferred`
/// of its momentum (ImpactSummary::transferred), and a string that still moves to the rock counts as e = 0.
/// nullopt where thrustProblem() says why.
std::optional<double> thrustNeeded(const Scenario& scenario, double cor, double transferred = 1);

/// Why there is no thrust for a scenario and what to do; empty when there is one.
Message thrustProblem(const Scenario& scenario);

/// Why there is no margin of the installed thrust, likewise.
Message thrustMarginProblem(const Scenario& scenario);

/// Why there is nothing per time for a scenario, `what` being "the thrust" or the like; empty when there is.
Message frequencyProblem(const Scenario& scenario, const char* what);

}  // namespace drillwave
