// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of many blows of a pinned run, laid over those of the scenario.
#pragma once

#include <optional>
#include <stop_token>

#include "ui/pages/drilling/drilling_question.h"
#include "ui/pages/study/run_studies.h"

namespace drillwave {

/// Means of a run in SI.
struct RunMeans {
    double penetration = 0;  ///< of a blow [m]
    double rate = 0;         ///< of penetration [m/s]
};

using RunDrilling = RunStudies<DrillingQuestion, RunMeans>;

/// Returns the question with as many cells as a scan.
DrillingQuestion runQuestion(const Scenario& scenario);

/// Returns nothing if the scenario cannot drill, or the machine is pushed back.
std::optional<RunMeans> runMeans(const DrillingQuestion& question, const std::stop_token& stop);

}  // namespace drillwave
