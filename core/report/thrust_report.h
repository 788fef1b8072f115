// SPDX-License-Identifier: GPL-3.0-or-later
// The thrust that blows need with all that is reported about it: text, JSON, CSV.
#pragma once

#include <optional>
#include <string>

#include "core/model/scenario.h"
#include "core/study/rows/sweep_axis.h"
#include "core/study/thrust/thrust_study.h"

namespace drillwave {

/// All that is reported.
struct ThrustReport {
    Scenario scenario;
    ThrustStudy study;
    std::optional<SweepAxis> frequencies;  ///< of drill.blow_frequency, for the table
    std::string scenarioText;              ///< gives the same scenario again

    /// The thrust f I0 (1+e) of a case at another blow frequency, the blow being the same [N].
    double thrustAt(double frequency, ThrustCase which) const;
};

/// Tables for people, and what the installed thrust means at the rig.
std::string thrustText(const ThrustReport& report);

/// One JSON object, SI.
std::string thrustJson(const ThrustReport& report);

/// The thrust f I0 (1+e) of each case against frequency: one row for each, in the unit in which it was typed
/// and N. Requires `frequencies`.
std::string thrustCsv(const ThrustReport& report);

}  // namespace drillwave
