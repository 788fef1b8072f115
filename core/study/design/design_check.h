// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a design study before anything is computed.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/study/design/design_study.h"

namespace drillwave {

/// Problem that prevents a design study, and whether the options given (isUsage) or the scenario cause it.
struct DesignProblemLine {
    bool isUsage = false;
    Message text;
};

/// Scenario parameter, by its key, that the user has declared as a design variable or as an uncertain input.
struct NamedKey {
    std::string key;
    /// Whether the key belongs to a design variable; otherwise to an uncertain input.
    bool isChosen = false;
    /// Whether the range is given as ± P per cent. Such a parameter may be uncertain and also be a design
    /// variable.
    bool isPercent = false;
    /// Design variable of presets that sets this parameter, such as "hammer"; empty if none does.
    std::string choice = {};
};

/// Returns the problems of a design study; empty if it can run. The checks find too many inputs, designs or
/// blows, a missing uncertain input, and two inputs that set the same value. They also find keys and outputs
/// that a design does not have, ranges that no design accepts, and an energy that cannot be kept.
/// Checking 10,000 designs takes some tenths of a second. A stop request returns the problems found so far.
/// `unread` lists keys whose values could not be read; they are checked for duplicates only.
std::vector<DesignProblemLine> problemsOf(const DesignStudy& study, const std::stop_token& stop = {},
                                          const std::vector<NamedKey>& unread = {});

}  // namespace drillwave
