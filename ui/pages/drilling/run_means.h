// SPDX-License-Identifier: GPL-3.0-or-later
// Means over many blows of a pinned run (a result kept for comparison).
#pragma once

#include <optional>
#include <stop_token>

#include "ui/pages/drilling/drilling_question.h"
#include "ui/pages/study/run_studies.h"

namespace drillwave {

/// Mean values over the blow sequence of a pinned run (a result kept for comparison), in SI units.
struct RunMeans {
    double penetration = 0;  ///< mean penetration of a blow [m]
    double rate = 0;         ///< mean penetration rate [m/s]
};

using RunDrilling = RunStudies<DrillingQuestion, RunMeans>;

/// Returns the input for the blow sequence of a pinned run (a result kept for comparison). Its time step is
/// coarse, as in a scan, so that it is computed quickly.
DrillingQuestion runQuestion(const Scenario& scenario);

/// Returns the means of a blow sequence. Nothing if the scenario is refused, or if the machine is pushed back
/// so that the motion is not bounded.
std::optional<RunMeans> runMeans(const DrillingQuestion& question, const std::stop_token& stop);

}  // namespace drillwave
