// SPDX-License-Identifier: GPL-3.0-or-later
// An axis of a study as a word of the command line.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/archive/row_record.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// Returns the axis given by `word` after --`option`, see parseAxis(). Throws CommandError: usage; invalid
/// scenario for a value that the parameter cannot take.
SweepAxis axisArgument(const std::string& option, const std::string& word);

/// Returns the range given by `word`, see parseRange(), or from STOP up to START where that is lower; throws
/// as axisArgument().
SweepAxis rangeArgument(const std::string& option, const std::string& word);

/// "--vary beta=1,2", for messages.
std::string quotedAxis(const std::string& option, const std::string& word);

/// Returns the number after --`option`, in SI for a quantity, which may have a unit. Throws CommandError
/// (usage).
double quantityArgument(const std::string& option, const std::string& word, Quantity quantity);

/// Returns the values of every --level. Throws CommandError (usage) also for more than mostLevels.
std::vector<double> levelArguments(const Arguments& arguments, Quantity quantity);

/// Returns the record of an axis as it was given.
RecordedAxis recordedAxis(const SweepAxis& axis, const std::string& word);

}  // namespace drillwave
