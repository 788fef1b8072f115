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

namespace drillwave {

/// All that is reported.
struct ThrustReport {
    Scenario scenario;
    ThrustStudy study;
    std::optional<ThrustAlong> along;
    std::string scenarioText;  ///< gives the same scenario again
};

/// The effective force over the largest of the needs, and which that is, in a sentence; empty where no thrust
/// is installed.
std::string marginSentence(const ThrustNeeds& needs);

/// Which impulse the thrust of a drill string is by, and why what counts its gaps is not told.
std::string_view stringThrustSentence();

/// What each of the four cases needs, for people: a line of titles, then one for each case. A study must be
/// there.
TextGrid needsGrid(const ThrustReport& report);

/// What the installed thrust means at the rig, in sentences; likewise.
std::vector<std::string> verdictSentences(const ThrustReport& report);

/// Tables for people, and what the installed thrust means at the rig.
std::string thrustText(const ThrustReport& report);

/// One JSON object, SI.
std::string thrustJson(const ThrustReport& report);

}  // namespace drillwave
