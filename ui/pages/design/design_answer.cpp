// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_answer.h"

#include <algorithm>

#include "core/model/blow_traits.h"
#include "core/numeric/available_threads.h"
#include "core/study/design/design_check.h"

namespace drillwave {

DesignAnswer answerDesign(const DesignStudy& asked, const StudyFeed<DesignAnswer>& feed) {
    DesignAnswer answer{.report = {.study = asked, .findings = {}, .scenarioText = {}},
                        .wanted = asked.samples,
                        .problems = {}};
    for (const DesignProblemLine& line : problemsOf(asked, feed.stop)) answer.problems.push_back(line.text);
    if (!answer.problems.empty() || feed.stop.stop_requested()) return answer;
    std::vector<DesignStudy> stages;
    const std::uint64_t first = isFollowedByEvents(asked.base) ? quickSamples : firstSamples;
    for (const std::uint64_t samples : {first, quickSamples, asked.samples}) {
        if (samples > asked.samples || (!stages.empty() && samples <= stages.back().samples)) continue;
        stages.push_back(asked);
        stages.back().samples = samples;
    }
    std::uint64_t wanted = 0;
    for (const DesignStudy& stage : stages) wanted += designSolves(stage);
    // The searches for worst cases take what they take: a stage counts no more than was thought of it, so
    // that the count never goes back where the next one begins.
    std::uint64_t done = 0, end = 0;
    const DesignWork work{.jobs = availableThreads(), .stop = feed.stop, .progress = [&](std::uint64_t more) {
                              done = std::min(done + more, end);
                              feed.tell({done, wanted});
                          }};
    for (const DesignStudy& stage : stages) {
        const bool isFirst = &stage == &stages.front(), isLast = &stage == &stages.back();
        answer.report.study = stage;
        done = end;
        end += designSolves(stage);
        answer.report.findings = runDesign(stage, work, [&](const DesignFindings& soFar) {
            if (!isFirst || isLast) return;  // what is there says more
            answer.report.findings = soFar;
            feed.show(answer);
        });
        if (const Message& unsolved = answer.report.findings.unsolved; !unsolved.isEmpty()) {
            answer.problems.push_back(unsolved);
            break;
        }
        if (isLast || feed.stop.stop_requested()) break;
        feed.show(answer);
    }
    return answer;
}

}  // namespace drillwave
