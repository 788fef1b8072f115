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

/// Input of the computation of one blow sequence. Its scenario has no title and no strengths, which do not
/// affect the result.
struct DrillingQuestion {
    Scenario scenario;
    DrillingSettings settings;
    bool operator==(const DrillingQuestion&) const = default;
};

/// Returns the input for the blow sequence of a scenario. windowSettingsOf() gives its number of blows.
DrillingQuestion drillingQuestion(const Scenario& scenario);

/// Result of one blow sequence; incomplete while it is computed, or after a stop.
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

/// Cache of computed blow sequences, so that undo shows a known result at once. Must not be used on two
/// threads at the same time.
class DrillingCache {
  public:
    /// Largest number of sequences that the cache keeps; the one that was not used for the longest time is
    /// dropped.
    static constexpr std::size_t keptAnswers = 32;
    /// Returns the sequence from the cache, or computes it and reports progress to `feed`.
    DrillingAnswer answer(const DrillingQuestion& question, const StudyFeed<DrillingAnswer>& feed);

  private:
    std::list<DrillingAnswer> m_known;  // latest first
};

/// Input of a scan: a blow sequence at each value of a range. `scenario` has the first value of the range
/// instead of the present one. So a change of the present value does not start the same scan again.
struct DrillingScanQuestion {
    Scenario scenario;
    StudyRange range;
    DrillingSettings settings;
    bool hasBracket = false;  ///< whether to scan also with a constant feed force and with a strong damper
    bool operator==(const DrillingScanQuestion&) const = default;
};

/// Largest number of parameter values in a scan, which computes one blow sequence for each value.
inline constexpr std::uint64_t scanPoints = 25;
/// Damping constant of the strong damper in a comparison scan, as a multiple of the impedance of the first
/// section of the string.
inline constexpr double strongDashpot = 0.5;

/// Returns the input of a scan: a blow sequence at each of several values in `range`. If `hasBracket`, the
/// scan is repeated with a constant feed force and with a strong damper.
DrillingScanQuestion drillingScanQuestion(const Scenario& scenario, const StudyRange& range, bool hasBracket);
/// Returns the estimated time of a scan on a typical computer [s].
double scanSeconds(const DrillingScanQuestion& question);
/// Returns the scanned range with the number of values as an argument of the command line, such as
/// "drill.thrust=5 kN:20 kN:25".
std::string scanAxisText(const StudyRange& range);

/// Result of a scan (a blow sequence at each value of a parameter); incomplete while it is computed, or after
/// a stop.
struct DrillingScanAnswer {
    std::vector<Message> refusals;
    std::shared_ptr<const DrillingScan> scan;
    /// Scans for comparison, with a constant feed force and with a strong damper at the feed; nullptr if not
    /// wanted or not possible.
    std::shared_ptr<const DrillingScan> constantForce, strongDamper;
};
/// Computes the scan and, if requested, the two scans for comparison. Reports each new value to `feed`.
/// Returns the result.
DrillingScanAnswer answerDrillingScan(const DrillingScanQuestion& question,
                                      const StudyFeed<DrillingScanAnswer>& feed);

}  // namespace drillwave
