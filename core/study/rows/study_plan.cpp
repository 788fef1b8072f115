// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/study_plan.h"

#include "core/blow/method.h"
#include "core/model/blow_traits.h"

namespace drillwave {

const StudyPlan& studyPlan(const Scenario& scenario) {
    static const StudyPlan byEvents{.workLimit = defaultWorkLimit,
                                    .designSamples = 4096,
                                    .firstSamples = 256,
                                    .unasked = {},
                                    .mapPoints = 200,
                                    .curvePoints = {},
                                    .curvePart = 6,
                                    .blowsOfPiece = {}};
    static const StudyPlan onCells{.workLimit = WorkLimits().cells / cellsOfPiece,
                                   .designSamples = 1024,
                                   .firstSamples = 16,
                                   .unasked = 10,
                                   .mapPoints = 40,
                                   .curvePoints = sampledPoints,
                                   .curvePart = 1,
                                   .blowsOfPiece = 40};
    return isFollowedByEvents(scenario) ? byEvents : onCells;
}

}  // namespace drillwave
