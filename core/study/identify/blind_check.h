// SPDX-License-Identifier: GPL-3.0-or-later
// Blind check of an identified law: prediction of the wave in the bar behind a specimen, compared with a
// gauge that the fit did not use.
#pragma once

#include <optional>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/law_fit.h"

namespace drillwave {

/// Returns how well the model predicts the wave in the bar behind the specimen. It is compared with the gauge
/// there, `distance` [m] from the specimen, in the time window of the fit. Empty if the record has no such
/// gauge or ends too early.
std::optional<BlindCheck> blindCheck(const GaugeRecord& given, double distance, RecordModel& model,
                                     const LawFit& fit);

}  // namespace drillwave
