// SPDX-License-Identifier: GPL-3.0-or-later
// Options for reading a measured record: --signal, the reading options and --recorder, which stores them
// under a name.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/signal/signal_reading.h"
#include "core/text/message.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Returns the options that say how to read a record, and --recorder, for a command's table of options.
std::vector<OptionSpec> signalOptionSpecs();

/// Returns the option --signal and the options that say how to read its record, for a command that reads a
/// scenario.
std::vector<OptionSpec> recordOptionSpecs();

/// Returns how to read a record: the settings stored under --recorder, overridden by the options given.
/// Throws CommandError.
SignalOptions signalOptionsOf(const Arguments& arguments);

/// Does nothing if a record was read and states everything. Otherwise throws CommandError with its problem or
/// its open questions: invalid scenario if an option is wrong or missing; unreadable input if the table
/// `name` is wrong.
void checkReading(const std::string& name, const Message& problem, bool isWrongOption,
                  const std::vector<std::string>& questions);

/// Stores the reading options of the command line under the name of --save-recorder; does nothing without it.
/// Throws CommandError.
void saveRecorder(const Arguments& arguments);

/// Replaces the hammer force of the scenario, or its hammer of sections, by the record of --signal; does
/// nothing without --signal. Leaves out samples so that impulse and coefficient of restitution change by at
/// most thinningError, unless --all-samples is given. Prints on stderr the number of samples used and
/// warnings on the record's quality, which the document stores. `path` names the scenario. Throws
/// CommandError: usage if a reading option is given without --signal; unreadable input; invalid scenario if
/// the record is not fully described.
void applySignal(ScenarioDocument& document, const Arguments& arguments, const std::string& path);

}  // namespace drillwave
