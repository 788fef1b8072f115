// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/study_plan.h"

#include "core/blow/method.h"
#include "core/model/blow_traits.h"

namespace drillwave {

StudyPlan studyPlan(const Scenario& scenario) {
    if (isFollowedByEvents(scenario)) return {};
    return {.workLimit = WorkLimits().cells / cellsOfPiece,
            .designSamples = 1024,
            .firstSamples = 16,
            .unasked = 10,
            .mapPoints = 40,
            .curvePoints = sampledPoints,
            .curvePart = 1,
            .blowsOfPiece = 40,
            .accuracySeconds = {}};
}

}  // namespace drillwave
