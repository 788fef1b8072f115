// SPDX-License-Identifier: GPL-3.0-or-later
// Results of the accuracy and stability studies, with their figures, tables and texts.
#pragma once

#include "core/report/study.h"
#include "core/study/proof/accuracy.h"
#include "core/study/proof/stability.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

/// Returns the result of an accuracy study. Its figure shows error against computing time with a series for
/// each method. Errors below the resolution of a double are drawn at that resolution (theory §9, strings
/// §11). Its table has the columns of the command. `runTime` is the computing time of the study [s].
StudyAnswerPtr accuracyAnswer(const Scenario& scenario, const Accuracy& accuracy, double runTime = 0);
StudyAnswerPtr accuracyAnswer(const Scenario& scenario, const StringAccuracy& accuracy, double runTime = 0);

/// Returns the result of a stability study. Its figure shows, for each test case, the check that comes
/// closest to its limit or exceeds it most, as a share of the limit. The x axis is β/γ, the fastest rate of
/// the impact force [1/t0]. Figure and table list the worst case first; the CSV keeps the order of the cases.
StudyAnswerPtr stabilityAnswer(const StabilityReport& report, double runTime = 0);

/// Returns the result of an accuracy study: the errors and computing times of the methods. For a uniform rod,
/// `ladder` lists the numbers of lattice segments to compare (see measureAccuracy()). For a drill string, it
/// is ignored (see measureStringAccuracy()).
StudyAnswerPtr studyAccuracy(const Scenario& scenario, const std::vector<int>& ladder, const StudyWork& work);

}  // namespace drillwave
