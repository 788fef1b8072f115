// SPDX-License-Identifier: GPL-3.0-or-later
// One of many blows with all that can be looked at in a single one (drilling §5).
#pragma once

#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/drilling/drilling_case.h"
#include "core/study/drilling/drilling_record.h"

namespace drillwave {

/// The blow of that number, from 1, of the march that studyDrilling() takes, to its last bit; times from when
/// it comes, to when the next one does. Its waves begin with those that are there then, its rock with what it
/// remembers, its gap with where the bit is: below 0 where it presses. Its scenario is a chain of sections,
/// also of a uniform rod. Waves fade where they come to the rear end of a section: what is in it has not
/// faded yet. Not solved where there are drillingRefusals(), the number is not from 1 to settings.blows, or
/// its blows take more than `mostWork` [cells times nodes] or more memory than a march may.
Blow marchedBlow(const Scenario& scenario, const DrillingSettings& settings, long number,
                 const std::stop_token& stop = {}, double mostWork = mostDrillingWork);

}  // namespace drillwave
