// SPDX-License-Identifier: GPL-3.0-or-later
// The thrust that blows need with all that is reported about it: text and JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/report/report_text.h"
#include "core/report/thrust_csv.h"
#include "core/study/thrust/thrust_study.h"
#include "core/text/message.h"

namespace drillwave {

/// What the verdict in words is by.
struct JudgedNeeds {
    const Scenario& scenario;
    const ThrustNeeds& needs;
    const FeedVerdict& verdict;
    std::optional<double> shareFull;  ///< ThrustStudy::shareFull, where it is known
};

/// All that is reported.
struct ThrustReport {
    Scenario scenario;
    ThrustStudy study;
    std::optional<ThrustAlong> along;
    std::string scenarioText;  ///< gives the same scenario again
    double runTime = 0;        ///< [s]

    JudgedNeeds judged() const { return {scenario, study.needs, study.verdict, study.shareFull}; }
};

/// What each of the four cases needs, for people: a line of titles, then one for each case. A study must be
/// there.
TextGrid needsGrid(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// What is to be done about the feed.
FeedDecision decisionOf(const JudgedNeeds& judged);

/// The sentence to act on, then what the installed thrust means at the rig: nothing in them says anything
/// else than the numbers of the needs.
std::vector<Message> verdictSentences(const JudgedNeeds& judged, const ReadingStyle& style = plainStyle());

/// Tables for people, and what the installed thrust means at the rig.
std::string thrustText(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// One JSON object, SI.
std::string thrustJson(const ThrustReport& report);

}  // namespace drillwave
