// SPDX-License-Identifier: GPL-3.0-or-later
// Study of the page Feed.
#pragma once

#include <memory>

#include "core/report/thrust_report.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/study_range.h"

namespace drillwave {

struct ThrustQuestion {
    Scenario scenario;
    StudyRange range;
    bool operator==(const ThrustQuestion&) const = default;
};

/// Answer so far.
struct ThrustAnswer {
    Scenario scenario;  ///< as it was asked
    ThrustAlong along;
    ThrustPoint here;  ///< of the scenario itself; its reason says why there are no numbers
    Message problem;   ///< thrustProblem(): then there is nothing else
    bool isComplete() const { return problem.isEmpty() && along.curve.points.size() == along.axis.count; }
};

/// Returns the range as words of the command, with a number of points if the default does not suit.
std::string axisText(const StudyRange& range);
/// The axis that the command line reads from that: the same values, in the same unit.
SweepAxis axisOf(const StudyRange& range);

/// Answers one question after another. Results that depend on the gap are kept for the next one, so that a
/// dragged feed force costs next to nothing. On one thread at a time.
class ThrustStudent {
  public:
    ThrustAnswer answer(const ThrustQuestion& question, const StudyFeed<ThrustAnswer>& feed);

  private:
    GapReboundFinder m_finder;
};

}  // namespace drillwave
