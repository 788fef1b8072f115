// SPDX-License-Identifier: GPL-3.0-or-later
// What blows require of the feed, with all that is reported about it: text and JSON.
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

/// All that is reported.
struct ThrustReport {
    Scenario scenario;
    ThrustStudy study;
    std::optional<ThrustAlong> along;
    std::string scenarioText;  ///< gives the same scenario again
    double runTime = 0;        ///< [s]
};

/// What each of the four cases needs, for people: a line of titles, then one for each case. A study must be
/// there.
TextGrid needsGrid(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// The estimate in words, then what the cases say of it. `shareCovered` is ThrustStudy::shareFull, where
/// known.
std::vector<Message> thrustSentences(const Scenario& scenario, const FeedEstimate& feed,
                                     const std::optional<double>& shareCovered,
                                     const ReadingStyle& style = plainStyle());

/// Sentences and tables for people.
std::string thrustText(const ThrustReport& report, const ReadingStyle& style = plainStyle());

/// One JSON object, SI.
std::string thrustJson(const ThrustReport& report);

}  // namespace drillwave
