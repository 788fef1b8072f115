// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks that follow from the result of a blow.
#pragma once

#include <vector>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/validation.h"

namespace drillwave {

/// Alerts of a solved blow, to be listed behind alertsFor(scenario):
/// `thrust_below_needed` when the feed is below what this blow requires (feed_estimate.h),
/// `super_rebound` when e > 1 by more than its error, `several_contacts` when the bit comes back to the rock,
/// `closed_form_invalid` for a rectangular blow on elastic rock that the paper's closed form is not for, with
/// the error that it would make, `reduced_accuracy` when the error bound of e exceeds 1e-9, `input_decides`
/// in its place when that is so because the bit chatters.
std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary);

/// Whether stressAlerts() needs to be asked, for which the largest forces must be known.
bool hasStrength(const Rod& rod);

}  // namespace drillwave
