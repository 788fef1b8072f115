// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_answer.h"

#include <algorithm>

#include "core/numeric/available_threads.h"
#include "core/study/design/design_check.h"
#include "core/study/rows/study_plan.h"
#include "ui/job/study_budget.h"

namespace drillwave {

namespace {

/// The study with few samples first, then with more.
std::vector<DesignStudy> stagesOf(const DesignStudy& asked) {
    std::vector<DesignStudy> stages;
    const auto first = static_cast<std::uint64_t>(studyPlan(asked.base).firstSamples);
    for (const std::uint64_t samples : {first, quickSamples, asked.samples}) {
        if (samples > asked.samples || (!stages.empty() && samples <= stages.back().samples)) continue;
        stages.push_back(asked);
        stages.back().samples = samples;
    }
    return stages;
}

}  // namespace

DesignAnswer answerDesign(const DesignQuestion& question, const StudyFeed<DesignAnswer>& feed) {
    const DesignStudy& asked = question.study;
    DesignAnswer answer{.report = {.study = asked, .findings = {}, .scenarioText = {}},
                        .wanted = asked.samples,
                        .problems = {}};
    for (const DesignProblemLine& line : problemsOf(asked, feed.stop)) answer.problems.push_back(line.text);
    if (!answer.problems.empty() || feed.stop.stop_requested()) return answer;
    const std::vector<DesignStudy> stages = stagesOf(asked);
    std::uint64_t wanted = 0;
    for (const DesignStudy& stage : stages) wanted += designSolves(stage);
    StudyBudget budget(question.seconds, feed.stop);
    // The searches for worst cases vary in length: a stage counts at most its estimate, so that the count
    // never decreases when the next one begins.
    std::uint64_t done = 0, end = 0, solved = 0;
    const auto secondsFor = [&](std::uint64_t solves) {
        return solved > 0 ? budget.elapsed() / double(solved) * double(solves) : 0;
    };
    const DesignWork work{
        .jobs = availableThreads(), .stop = budget.token(), .progress = [&](std::uint64_t more) {
            solved += more;
            done = std::min(done + more, end);
            feed.tell({done, wanted});
            budget.check();
        }};
    for (const DesignStudy& stage : stages) {
        const bool isFirst = &stage == &stages.front(), isLast = &stage == &stages.back();
        if (!isFirst && !budget.hasRoomFor(secondsFor(designSolves(stage)))) {
            answer.secondsLeft = secondsFor(wanted - end);
            break;
        }
        const DesignAnswer before = answer;
        answer.report.study = stage;
        done = end;
        end += designSolves(stage);
        DesignFindings shown;
        DesignFindings found = runDesign(stage, work, [&](const DesignFindings& soFar) {
            shown = soFar;
            if (!isFirst || isLast) return;  // the present answer is better
            answer.report.findings = soFar;
            feed.show(answer);
        });
        if (budget.isSpent() && budget.token().stop_requested() && !feed.stop.stop_requested()) {
            // The stage is whole as far as it was shown.
            if (!shown.best.robust && before.hasBest())
                answer = before;
            else
                answer.report.findings = std::move(shown);
            answer.secondsLeft = secondsFor(wanted - done);
            break;
        }
        answer.report.findings = std::move(found);
        if (const Message& unsolved = answer.report.findings.unsolved; !unsolved.isEmpty()) {
            answer.problems.push_back(unsolved);
            break;
        }
        if (isLast || feed.stop.stop_requested()) break;
        feed.show(answer);
    }
    return answer;
}

std::vector<ParameterValue> worstInputs(const DesignStudy& study, const WorstCase& worst) {
    std::vector<ParameterValue> inputs;
    if (worst.at.size() < study.dimensions()) return inputs;
    for (std::size_t i = 0; i < study.uncertain.size(); ++i)
        inputs.push_back({study.uncertain[i].parameter, worst.at[i]});
    if (!study.draws) return inputs;
    const auto row = static_cast<std::size_t>(worst.at[study.uncertain.size()]);
    for (std::size_t i = 0; i < study.draws->parameters.size(); ++i)
        inputs.push_back({study.draws->parameters[i], study.draws->columns[i][row]});
    return inputs;
}

}  // namespace drillwave
