// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of the studies of accuracy and stability: their figures, tables and texts.
#pragma once

#include "core/report/study.h"
#include "core/study/proof/accuracy.h"
#include "core/study/proof/stability.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

/// Error against run time, a series for each method; errors below the resolution of a double are shown there
/// (theory §9, strings §11). The table has the columns of the command. The study took `runTime` [s].
StudyAnswerPtr accuracyAnswer(const Scenario& scenario, const Accuracy& accuracy, double runTime = 0);
StudyAnswerPtr accuracyAnswer(const Scenario& scenario, const StringAccuracy& accuracy, double runTime = 0);

/// The worst check of each case over its limit, against β/γ, the stiffest rate. Figure and table have the
/// worst case first, the CSV has the cases in their order.
StudyAnswerPtr stabilityAnswer(const StabilityReport& report, double runTime = 0);

/// Measures a uniform rod over `ladder` (measureAccuracy()), or a drill string (measureStringAccuracy()).
StudyAnswerPtr studyAccuracy(const Scenario& scenario, const std::vector<int>& ladder, const StudyWork& work);

}  // namespace drillwave
