// SPDX-License-Identifier: GPL-3.0-or-later
// Problems of a design study, found before anything is computed.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/study/design/design_study.h"

namespace drillwave {

/// A problem, and its cause: the words of the question or the scenario.
struct DesignProblemLine {
    bool isUsage = false;
    Message text;
};

/// A key that the question names, and where.
struct NamedKey {
    std::string key;
    bool isChosen = false;
    bool isPercent = false;   ///< of a range: ± P %, which a choice may have too
    std::string choice = {};  ///< the chosen part whose presets set it: "hammer"; empty if none do
};

/// All of it: too many of anything, nothing uncertain, two that set one thing, keys and outputs that a design
/// has not, ranges that no design takes, an energy that cannot be kept. Empty when it can run. Ten thousand
/// designs take some tenths of a second: a stop ends it with what was found by then. `unread` are keys whose
/// values could not be read and which the study therefore has not: they too may be given twice.
std::vector<DesignProblemLine> problemsOf(const DesignStudy& study, const std::stop_token& stop = {},
                                          const std::vector<NamedKey>& unread = {});

}  // namespace drillwave
