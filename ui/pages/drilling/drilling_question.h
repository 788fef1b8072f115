// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of the page Drilling: a march of many blows, and a scan of such marches over a parameter.
#pragma once

#include <list>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/report/figure.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/scan/drilling_scan.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/study_range.h"

namespace drillwave {

/// A march, without what changes nothing of it: title and strengths.
struct DrillingQuestion {
    Scenario scenario;
    DrillingSettings settings;
    bool operator==(const DrillingQuestion&) const = default;
};

/// Returns the question with windowSettingsOf().
DrillingQuestion drillingQuestion(const Scenario& scenario);

struct DrillingAnswer {
    DrillingQuestion question;
    std::vector<Message> refusals;      ///< drillingRefusals(): then there is nothing else
    std::vector<DrillingBlow> growing;  ///< the blows so far, until there is a result
    std::shared_ptr<const DrillingResult> result;
    FigureSeries corOverGap;  ///< corOverPeriod()

    const std::vector<DrillingBlow>& blows() const { return result ? result->blows : growing; }
    /// Whether the march has come to its end.
    bool isComplete() const { return result && result->outcome != DrillingOutcome::stopped; }
};

/// Answers one question after another and keeps the last answers, so that undo costs nothing. Use it on one
/// thread at a time.
class DrillingCache {
  public:
    static constexpr std::size_t keptAnswers = 32;
    DrillingAnswer answer(const DrillingQuestion& question, const StudyFeed<DrillingAnswer>& feed);

  private:
    std::list<DrillingAnswer> m_known;  // the latest in front
};

/// Marches over the values of an axis. The scenario has the first value of it, so that the question is the
/// same wherever along it one is.
struct DrillingScanQuestion {
    Scenario scenario;
    StudyRange range;
    DrillingSettings settings;
    bool hasBracket = false;  ///< also under a constant force and with a strong dashpot
    bool operator==(const DrillingScanQuestion&) const = default;
};

inline constexpr std::uint64_t scanPoints = 25;
/// The dashpot of a bracket, of the impedance of the first section.
inline constexpr double strongDashpot = 0.5;

DrillingScanQuestion drillingScanQuestion(const Scenario& scenario, const StudyRange& range, bool hasBracket);
/// Time of a scan on a typical computer [s].
double scanSeconds(const DrillingScanQuestion& question);
/// The axis as the command takes it.
std::string scanAxisText(const StudyRange& range);

struct DrillingScanAnswer {
    std::vector<Message> refusals;
    std::shared_ptr<const DrillingScan> scan;
    std::shared_ptr<const DrillingScan> constantForce, strongDamper;  ///< where they are wanted and possible
};
DrillingScanAnswer answerDrillingScan(const DrillingScanQuestion& question,
                                      const StudyFeed<DrillingScanAnswer>& feed);

}  // namespace drillwave
