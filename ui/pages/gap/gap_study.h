// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the page COR–gap: coarse first where a blow takes its time.
#pragma once

#include <optional>
#include <vector>

#include "core/report/gap_report.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// What is asked. The gap of the scenario does not matter, and is 0 here: a gap that is dragged asks nothing
/// new.
struct GapQuestion {
    Scenario scenario;
    std::optional<NormalGap> normal;
    bool operator==(const GapQuestion& other) const;
};

/// Why a scatter cannot be studied, in a sentence; empty when it can.
QString scatterProblem(const NormalGap& normal);

/// Requires a uniform rod.
GapQuestion gapQuestion(Scenario scenario, const std::optional<NormalGap>& normal);

/// Outputs at one gap, in the order of GapOutput.
struct GapSample {
    double gap = 0;  ///< d0
    std::array<double, gapOutputCount> values{};
};

/// What is known so far.
struct GapAnswer {
    GapReport report;                ///< of the question's scenario
    std::vector<GapSample> samples;  ///< ascending, while there is no more: the report holds no curve then
    bool isComplete() const { return report.curve.isComplete(); }
};

/// Throws std::runtime_error, with a sentence, where there is no answer at all gaps.
GapAnswer answerGap(const GapQuestion& question, const StudyFeed<GapAnswer>& feed);

}  // namespace drillwave
