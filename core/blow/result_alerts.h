// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts that follow from the result of a blow.
#pragma once

#include <vector>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/validation.h"

namespace drillwave {

/// Returns the alerts of a solved blow, to be listed after alertsFor(scenario). `thrust_below_needed`: the
/// feed force is below the required one of this blow. `super_rebound`: the coefficient of restitution e of a
/// uniform rod exceeds 1 by more than its error. `several_contacts`: the bit returns to the rock.
/// `closed_form_invalid`: a rectangular blow on elastic rock is outside the range of the analytical solution,
/// whose error the alert states. `corners_without_effect`: the force stays below the first corner of the rock
/// law. `reduced_accuracy`: the error bound of e exceeds 1e-9; if the bit chatters, `input_decides` replaces
/// it.
std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary);

/// Returns whether a rod has a yield or fatigue strength. Then its largest forces must be computed, so that
/// stressAlerts() can compare them with the strength.
bool hasStrength(const Rod& rod);

}  // namespace drillwave
