// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios with which many tests start.
#pragma once

#include "core/model/scenario.h"

namespace drillwave::test {

/// Returns a dimensionless scenario, by default that of Fig. 4 (a) of the paper.
inline Scenario dimensionless(PulseShape shape = PulseShape::rectangular, const Groups& groups = {}) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = groups;
    scenario.pulse.shape = shape;
    return scenario;
}

}  // namespace drillwave::test
