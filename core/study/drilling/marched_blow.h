// SPDX-License-Identifier: GPL-3.0-or-later
// One blow of a sequence, with all results of a single blow (drilling §5).
#pragma once

#include <stop_token>

#include "core/blow/blow.h"
#include "core/study/drilling/drilling_case.h"
#include "core/study/drilling/drilling_record.h"

namespace drillwave {

/// Returns blow `number` (from 1) of the sequence that studyDrilling() computes, with identical values but
/// with all histories. Times run from the start of this blow to the start of the next one.
/// The blow starts with the waves, the rock memory and the gap present at that time; the gap is negative if
/// the bit presses on the rock. The scenario of the returned blow is always a drill string of sections, even
/// for a uniform rod. Wave loss acts at the rear end of a section. Waves inside the section therefore do not
/// yet include the loss.
/// The blow is not solved if drillingRefusals() is not empty, or if `number` is not in 1 … settings.blows. It
/// is also not solved if the computation exceeds `mostWork` [time steps × nodes] or the permitted memory.
Blow marchedBlow(const Scenario& scenario, const DrillingSettings& settings, long number,
                 const std::stop_token& stop = {}, double mostWork = mostDrillingWork);

}  // namespace drillwave
