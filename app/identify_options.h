// SPDX-License-Identifier: GPL-3.0-or-later
// From the words of `identify` to its question.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/model/scenario.h"
#include "core/study/identify/identify_question.h"

namespace drillwave {

/// The options of `identify`: of scenarios, of reading, and its own.
std::vector<OptionSpec> identifyOptionSpecs();

/// FILE and the records of --signals, in their order.
struct IdentifyFiles {
    std::string scenario;
    std::vector<std::string> records;
};
/// Throws CommandError (usage) where FILE or --signals is missing or a record is given twice.
IdentifyFiles identifyFiles(const Arguments& arguments);

/// Reads the records and makes the question. Throws CommandError: usage, unreadable input, invalid scenario.
IdentifyQuestion identifyQuestionOf(const Arguments& arguments, const Scenario& scenario,
                                    const std::string& path, const std::vector<std::string>& records,
                                    const std::stop_token& stop);

}  // namespace drillwave
