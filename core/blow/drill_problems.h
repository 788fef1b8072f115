// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a scenario can be drilled with, blow after blow.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Blows of a study of many values, of which each is marched, and how many of them settle, where the scenario
/// says nothing of either.
inline constexpr long scanBlows = 300, scanSettle = 100;

/// How many blows are followed, and how many at first no statistic counts.
struct DrillLength {
    long blows = scanBlows;
    long settle = scanSettle;
};

/// Of a study of many values: what the scenario says; a fifth of the blows settle where it says nothing of
/// that alone.
DrillLength scanLengthOf(const Scenario& scenario);

/// Why a valid scenario cannot be drilled with, each with its key: "drill.thrust: is missing …". Empty where
/// it can.
std::vector<Message> drillProblems(const Scenario& scenario, const DrillLength& length);

/// All of them in a line, of a study of many values.
Message drillProblem(const Scenario& scenario);

}  // namespace drillwave
