// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/run_lines.h"

#include "core/model/blow_traits.h"
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
    if (!isFollowedByEvents(run) && isFollowedByEvents(page.base)) question.along.count = sampledPoints;
    const bool isUsable =
        isFollowedByEvents(run) ? problemsOf(question).empty() : sampledProblemsOf(question).empty();
    return isUsable ? std::optional(question) : std::nullopt;
}

std::optional<CurveStudy> runLine(const CurveQuestion& question, const std::stop_token& stop) {
    constexpr int jobs = 1;  // the others are left to what the user waits for
    CurveStudy study = isFollowedByEvents(question.base) ? studyCurve(question, jobs, stop)
                                                         : sampleCurve(question, jobs, stop);
    if (study.stopped) return std::nullopt;
    return study;
}

}  // namespace drillwave
