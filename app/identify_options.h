// SPDX-License-Identifier: GPL-3.0-or-later
// From the words of `identify` to its question.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "core/model/scenario.h"
#include "core/study/identify/gauge_reading.h"
#include "core/study/identify/identify_question.h"

namespace drillwave {

/// The options of `identify`: of scenarios, of reading, and its own.
std::vector<OptionSpec> identifyOptionSpecs();

/// Returns the share of a percentage such as "2%"; nothing for another text.
std::optional<double> percentageOf(std::string_view text);

/// A gauge of `--gauge`, `--check` or `--record`: COLUMN@DISTANCE. Throws CommandError: usage; invalid
/// scenario where the distance is none.
GaugeChoice gaugeChoiceOf(const std::string& name, const std::string& word);

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
