// SPDX-License-Identifier: GPL-3.0-or-later
// What distinguishes one scenario from another, in few words.
#pragma once

#include <QString>

#include "core/model/scenario.h"

namespace drillwave {

class UnitChoice;

/// What the second scenario has instead, in the units of the fields: "k 300 MN/m, L 12 ft", "half sine". At
/// most a few changes, the rest as "…". Empty where they differ in nothing but the title.
QString changeWords(const Scenario& before, const Scenario& after, const UnitChoice& units);

}  // namespace drillwave
