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

/// Returns the descriptions of the options for reading a record, including --recorder.
std::vector<OptionSpec> signalOptionSpecs();

/// Returns the descriptions of --signal and of the options for reading its record, for commands that read a
/// scenario.
std::vector<OptionSpec> recordOptionSpecs();

/// Returns the settings for reading a measured record: those stored under the name of --recorder, overridden
/// by the options given. Throws CommandError.
SignalOptions signalOptionsOf(const Arguments& arguments);

/// Throws CommandError if reading a record failed with `problem`, or left `questions` open, such as its unit.
/// The exit code is invalid scenario if an option is wrong or missing, and unreadable input if the table
/// `name` is wrong. Does nothing otherwise.
void checkReading(const std::string& name, const Message& problem, bool isWrongOption,
                  const std::vector<std::string>& questions);

/// Stores the reading options of the command line as a recorder, under the name of --save-recorder; does
/// nothing without this option. Throws CommandError.
void saveRecorder(const Arguments& arguments);

/// Replaces the hammer of the scenario by the force measured in the file of --signal; does nothing without
/// --signal. Leaves out samples so that impulse and coefficient of restitution change by at most
/// thinningError (10⁻⁴), unless --all-samples is given. Prints on stderr the number of samples used, and
/// warnings on the quality of the measurement, which `document` also stores. `path` names the scenario.
/// Throws CommandError: usage if a reading option is given without --signal; unreadable input; invalid
/// scenario if the signal is not fully described.
void applySignal(ScenarioDocument& document, const Arguments& arguments, const std::string& path);

}  // namespace drillwave
