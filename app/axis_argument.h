// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an axis of a study (a parameter with its values) from a word of the command line.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/archive/row_record.h"
#include "core/study/design/design_texts.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave {

/// Returns the axis (a parameter with its values) that `word` describes, in the syntax of parseAxis().
/// `option` is the option's name for messages. Throws CommandError: invalid scenario for a value that the
/// parameter cannot take, usage for any other mistake.
SweepAxis axisArgument(const std::string& option, const std::string& word);

/// Returns the axis (a parameter with its values, or presets) that `word` describes, in the syntax of
/// parseAxisOrPresets(). Presets are looked up in `presets`. Throws CommandError: invalid scenario for a
/// value that the parameter cannot take, usage for any other mistake.
SweepAxis axisOrPresetsArgument(const std::string& option, const std::string& word, const Scenario& scenario,
                                const PresetLookup& presets);

/// Returns the range of a parameter that `word` describes, in the syntax of parseRange(). Its ends are
/// swapped if the first is higher. Throws CommandError: invalid scenario for a value that the parameter
/// cannot take, usage for any other mistake.
SweepAxis rangeArgument(const std::string& option, const std::string& word);

/// Returns an option with its value as typed, for messages: "--vary beta=1,2".
std::string quotedAxis(const std::string& option, const std::string& word);

/// Returns the number in `word`, in SI. `word` may include a unit of `quantity`; without one it is in SI.
/// `option` is the option's name for messages. Throws CommandError (usage) for any other text.
double quantityArgument(const std::string& option, const std::string& word, Quantity quantity);

/// Returns the values of all --level options (levels of contour lines), in SI. Throws CommandError (usage)
/// for a wrong value or more than 100 levels.
std::vector<double> levelArguments(const Arguments& arguments, Quantity quantity);

/// Returns the axis in the form stored in the file that describes a result (FILE.csv.yaml). It consists of
/// column header, values as typed in `word`, and their number.
RecordedAxis recordedAxis(const SweepAxis& axis, const std::string& word);

}  // namespace drillwave
