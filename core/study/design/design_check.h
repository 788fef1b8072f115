// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a design study unusable, found before anything is computed.
#pragma once

#include <string>
#include <vector>

#include "core/study/design/design_study.h"

namespace drillwave {

/// A line, and whether the words of the question are at fault or what the scenario is.
struct DesignProblemLine {
    bool isUsage = false;
    std::string text;
};

/// All of it: too many of anything, nothing uncertain, two that set one thing, keys and outputs that a design
/// has not, ranges that no design takes, an energy that cannot be kept. Empty when it can run.
std::vector<DesignProblemLine> problemsOf(const DesignStudy& study);

}  // namespace drillwave
