// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks that follow from the result of a blow.
#pragma once

#include <vector>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/validation.h"

namespace drillwave {

/// Returns the alerts of a solved blow, to be listed after alertsFor(scenario): `thrust_below_needed` when
/// the feed is below the required force of this blow (feed_estimate.h), `super_rebound` when e > 1 by more
/// than its error, `several_contacts` when the bit returns to the rock, `closed_form_invalid` for a
/// rectangular blow on elastic rock outside the range of the paper's closed form, with the error that it
/// would make, `reduced_accuracy` when the error bound of e exceeds 1e-9, or `input_decides` instead if the
/// bit chatters.
std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary);

/// Returns whether stressAlerts() has anything to check, for which the largest forces must be known.
bool hasStrength(const Rod& rod);

}  // namespace drillwave
