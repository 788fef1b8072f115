// SPDX-License-Identifier: GPL-3.0-or-later
// Options of the command `identify` (finding the rock's law from measured strains), converted to a question.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/model/scenario.h"
#include "core/study/identify/gauge_reading.h"
#include "core/study/identify/identify_question.h"

namespace drillwave {

/// Returns the descriptions of all options that the command `identify` accepts.
std::vector<OptionSpec> identifyOptionSpecs();

/// Returns the strain gauge that `word` describes as COLUMN@DISTANCE; `name` is its option, for messages.
/// Throws CommandError with the exit code of usage if the form is another one, and with that of an invalid
/// scenario if the distance is not a positive length.
GaugeChoice gaugeChoiceOf(const std::string& name, const std::string& word);

/// Files that the command `identify` reads: the scenario, and the records of --signals in the order given.
struct IdentifyFiles {
    std::string scenario;
    std::vector<std::string> records;
};
/// Returns the files that the command line names. Throws CommandError (usage) if the scenario or --signals is
/// missing or a record is given twice.
IdentifyFiles identifyFiles(const Arguments& arguments);

/// Reads the records and returns the input of the identification. `path` names the scenario in messages.
/// Throws CommandError: usage, unreadable input, invalid scenario.
IdentifyQuestion identifyQuestionOf(const Arguments& arguments, const Scenario& scenario,
                                    const std::string& path, const std::vector<std::string>& records,
                                    const std::stop_token& stop);

}  // namespace drillwave
