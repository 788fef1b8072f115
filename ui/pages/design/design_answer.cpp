// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_answer.h"

#include <QThread>
#include <algorithm>

#include "core/study/design/design_check.h"

namespace drillwave {

DesignAnswer answerDesign(const DesignStudy& asked, const StudyFeed<DesignAnswer>& feed) {
    DesignAnswer answer{.report = {.study = asked, .findings = {}, .scenarioText = {}},
                        .wanted = asked.samples,
                        .problems = {}};
    for (const DesignProblemLine& line : problemsOf(asked, feed.stop)) answer.problems.push_back(line.text);
    if (!answer.problems.empty() || feed.stop.stop_requested()) return answer;
    DesignStudy quick = asked;
    quick.samples = std::min(quickSamples, asked.samples);
    const bool isAll = quick.samples == asked.samples;
    const std::uint64_t wanted = designSolves(asked) + (isAll ? 0 : designSolves(quick));
    std::uint64_t done = 0;
    const DesignWork work{.jobs = std::max(1, QThread::idealThreadCount()),
                          .stop = feed.stop,
                          .progress = [&](std::uint64_t more) {
                              done = std::min(done + more, wanted);
                              feed.tell({done, wanted});
                          }};
    const auto run = [&](const DesignStudy& study, const ShowFindings& show) {
        answer.report.study = study;
        answer.report.findings = runDesign(study, work, show);
    };
    if (!isAll) {
        run(quick, [&](const DesignFindings& soFar) {
            answer.report.findings = soFar;
            feed.show(answer);
        });
        if (feed.stop.stop_requested()) return answer;
        feed.show(answer);
        done = designSolves(quick);
    }
    run(asked, {});
    return answer;
}

}  // namespace drillwave
