// Remarks that follow from the result of a blow.
#pragma once

#include <vector>

#include "core/model/validation.h"
#include "core/study/impact_summary.h"

namespace drillwave {

/// Alerts of a solved blow, to be listed behind alertsFor(scenario):
/// `thrust_below_needed` when the installed thrust is less than blow_frequency·I0·(1 + e), `super_rebound`
/// when e > 1 by more than its error, `reduced_accuracy` when the error bound of e exceeds 1e-9.
std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary);

}  // namespace drillwave
