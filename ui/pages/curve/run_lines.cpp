// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/run_lines.h"

#include "core/study/rows/study_plan.h"
#include "ui/pages/curve/curve_study.h"

namespace drillwave {

std::optional<CurveQuestion> runLineQuestion(const CurveQuestion& page, const Scenario& run) {
    const bool isSi = page.columns.front().units == OutputUnits::si;
    if (isSi && run.form == ScenarioForm::dimensionless) return std::nullopt;
    if (!page.along.parameter->applies(run)) return std::nullopt;
    CurveQuestion question = page;
    question.base = run;
    question.base.title.clear();
    question.family.reset();
    question.levels.clear();  // nothing is marked on it
    question.goal.reset();
    takeOut(question.base, *question.along.parameter, question.along.start);
    const std::optional<std::uint64_t> points = studyPlan(run).curvePoints;
    if (points && !studyPlan(page.base).curvePoints) question.along.count = *points;
    return problemsOf(CurvePageQuestion{question}).empty() ? std::optional(question) : std::nullopt;
}

std::optional<CurveStudy> runLine(const CurveQuestion& question, const std::stop_token& stop) {
    constexpr int jobs = 1;  // the others are left to what the user waits for
    CurveStudy study = studyCurvePage({question}, jobs, stop).curve;
    if (study.stopped) return std::nullopt;
    return study;
}

}  // namespace drillwave
