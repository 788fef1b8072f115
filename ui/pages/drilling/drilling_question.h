// SPDX-License-Identifier: GPL-3.0-or-later
// Questions of the page Drilling: a sequence of many blows, and a scan of such sequences over a parameter.
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

/// Question for one blow sequence. The scenario has no title and no strengths, which do not affect the
/// answer.
struct DrillingQuestion {
    Scenario scenario;
    DrillingSettings settings;
    bool operator==(const DrillingQuestion&) const = default;
};

/// Returns the question for a scenario, with the number of blows of windowSettingsOf().
DrillingQuestion drillingQuestion(const Scenario& scenario);

/// Answer for one blow sequence, possibly incomplete.
struct DrillingAnswer {
    DrillingQuestion question;
    std::vector<Message> refusals;      ///< errors of drillingRefusals(); if not empty, there is no result
    std::vector<DrillingBlow> growing;  ///< blows computed so far; empty once there is a result
    std::shared_ptr<const DrillingResult> result;
    FigureSeries corOverGap;  ///< series of corOverPeriod(); empty until the sequence is complete

    const std::vector<DrillingBlow>& blows() const { return result ? result->blows : growing; }
    /// Returns whether the sequence was computed to its end.
    bool isComplete() const { return result && result->outcome != DrillingOutcome::stopped; }
};

/// Cache that answers one question after another and keeps the latest answers, so that undo is immediate.
/// Must not be used on two threads at the same time.
class DrillingCache {
  public:
    /// Largest number of answers that are kept.
    static constexpr std::size_t keptAnswers = 32;
    /// Returns the answer from the cache, or computes it and reports progress to `feed`.
    DrillingAnswer answer(const DrillingQuestion& question, const StudyFeed<DrillingAnswer>& feed);

  private:
    std::list<DrillingAnswer> m_known;  // latest first
};

/// Question for a scan: a blow sequence at each value of a range. The scenario always has the first value of
/// the range, so that questions with different present values are equal.
struct DrillingScanQuestion {
    Scenario scenario;
    StudyRange range;
    DrillingSettings settings;
    bool hasBracket = false;  ///< whether to scan also with a constant feed force and with a strong damper
    bool operator==(const DrillingScanQuestion&) const = default;
};

/// Largest number of values of a scan.
inline constexpr std::uint64_t scanPoints = 25;
/// Damping of the strong damper, as a multiple of the impedance of the first section of the string.
inline constexpr double strongDashpot = 0.5;

/// Returns the question for a scan over `range`. If `hasBracket`, the scan is repeated with a constant feed
/// force and with a strong damper.
DrillingScanQuestion drillingScanQuestion(const Scenario& scenario, const StudyRange& range, bool hasBracket);
/// Returns the estimated time of a scan on a typical computer [s].
double scanSeconds(const DrillingScanQuestion& question);
/// Returns the scanned range as an argument of the command, with the number of values.
std::string scanAxisText(const StudyRange& range);

/// Answer for a scan, possibly incomplete.
struct DrillingScanAnswer {
    std::vector<Message> refusals;
    std::shared_ptr<const DrillingScan> scan;
    /// Scans for comparison; nullptr if not wanted or not possible.
    std::shared_ptr<const DrillingScan> constantForce, strongDamper;
};
/// Computes the scans one after another and reports each new value to `feed`. Returns the answer.
DrillingScanAnswer answerDrillingScan(const DrillingScanQuestion& question,
                                      const StudyFeed<DrillingScanAnswer>& feed);

}  // namespace drillwave
