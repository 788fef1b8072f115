// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/design_run.h"

#include <algorithm>

#include "app/progress_bar.h"
#include "app/scenario_argument.h"
#include "core/report/design_words.h"

namespace drillwave {

namespace {

/// Throws if no design can be taken: none has statistics, or none meets the limits.
void checkFeasible(const DesignStudy& study, const DesignFindings& findings, const DesignRun& run) {
    if (findings.best.robust) return;
    if (!findings.unsolved.isEmpty())
        throw CommandError(ExitCode::unsolvedOrFailed,
                           couldNotBeSolved(run.path, reasonWithHint(findings.unsolved, study.workLimit)));
    std::vector<Message> lines;
    for (const DesignSamples& design : findings.designs) {
        if (design.hasStatistics(study.samples) || !lines.empty()) continue;
        lines.emplace_back(
            translatable("%1: too many samples could not be solved, so designs have no statistics: %2 of %3; "
                         "the first: %4"),
            std::vector<Message>{run.path, std::to_string(design.unsolved), std::to_string(study.samples),
                                 reasonWithHint(design.reason, study.workLimit)});
    }
    if (!study.limits.empty()) {
        lines.push_back(
            about(run.path, translatable("no design meets all limits; loosen one or widen the choices")));
        for (Message& line : nearestToLimits(study, findings, run.style)) lines.push_back(std::move(line));
    }
    if (lines.empty())
        lines.push_back(
            about(run.path, translatable("the scenario could not be solved with the values entered")));
    throw CommandError(ExitCode::unsolvedOrFailed, std::move(lines), CommandError::Begin::withOption);
}

}  // namespace

DesignFindings findDesigns(const DesignStudy& study, const DesignRun& run, const Interruption& interruption) {
    ProgressBar bar(designSolves(study), translatable("blows"), run.style);
    std::uint64_t solved = 0;
    DesignFindings findings = runDesign(
        study, {.jobs = run.jobs, .stop = interruption.token(), .progress = [&](std::uint64_t more) {
                    bar.show(std::min(solved += more, designSolves(study)));
                }});
    interruption.check();
    checkFeasible(study, findings, run);
    return findings;
}

}  // namespace drillwave
