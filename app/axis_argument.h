// SPDX-License-Identifier: GPL-3.0-or-later
// An axis of a study as a word of the command line.
#pragma once

#include <string>

#include "app/arguments.h"
#include "core/file/row_record.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// The axis that `word` behind --`option` says, see parseAxis(). Throws CommandError: usage, also where --set
/// sets what it varies; invalid scenario for a value that the parameter cannot take.
SweepAxis axisArgument(const Arguments& arguments, const std::string& option, const std::string& word);

/// The axis as it was asked for.
RecordedAxis recordedAxis(const SweepAxis& axis, const std::string& word);

}  // namespace drillwave
