// SPDX-License-Identifier: GPL-3.0-or-later
// One blow of a sequence, with all results of a single blow (drilling §5).
#pragma once

#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/drilling/drilling_case.h"
#include "core/study/drilling/drilling_record.h"

namespace drillwave {

/// Returns blow `number` (from 1) of the sequence that studyDrilling() computes, identical to the last bit.
/// Times run from the start of this blow to that of the next one.
/// The blow starts with the waves, the rock memory and the gap present at that time; the gap is negative if
/// the bit presses. The scenario of the returned blow is always a string of sections, even for a uniform rod.
/// Wave loss acts at the rear end of a section, so waves inside it are still without the loss.
/// Not solved if drillingRefusals() is not empty, or if `number` is not in 1 … settings.blows. It is also not
/// solved if the blows exceed `mostWork` [cells × nodes] or the permitted memory.
Blow marchedBlow(const Scenario& scenario, const DrillingSettings& settings, long number,
                 const std::stop_token& stop = {}, double mostWork = mostDrillingWork);

}  // namespace drillwave
