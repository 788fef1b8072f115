// SPDX-License-Identifier: GPL-3.0-or-later
// One of many blows with all that can be looked at in a single one (drilling §5).
#pragma once

#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/drilling/drilling_case.h"
#include "core/study/drilling/drilling_record.h"

namespace drillwave {

/// Returns the blow of that number, from 1, of the march of studyDrilling(), to its last bit; times from its
/// start to that of the next one. It starts with the present waves, with the memory of its rock and with the
/// present gap: below 0 where the bit presses. Its scenario is a chain of sections, also for a uniform rod.
/// Waves fade at the rear end of a section: its content has not faded yet. Not solved if there are
/// drillingRefusals(), if the number is not from 1 to settings.blows, or if its blows take more than
/// `mostWork` [cells × nodes] or more memory than a march may.
Blow marchedBlow(const Scenario& scenario, const DrillingSettings& settings, long number,
                 const std::stop_token& stop = {}, double mostWork = mostDrillingWork);

}  // namespace drillwave
