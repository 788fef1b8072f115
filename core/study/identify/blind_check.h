// SPDX-License-Identifier: GPL-3.0-or-later
// Wave in the bar behind a specimen, predicted from the identified law without its gauge.
#pragma once

#include <optional>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/law_fit.h"

namespace drillwave {

/// Compares the force that the model sends into the bar behind with the gauge there, `distance` from the
/// specimen [m], within the window of the fit. Nothing where the record has no such gauge, or ends too early.
std::optional<BlindCheck> blindCheck(const GaugeRecord& given, double distance, RecordModel& model,
                                     const LawFit& fit);

}  // namespace drillwave
