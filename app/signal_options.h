// SPDX-License-Identifier: GPL-3.0-or-later
// The options by which a record is read, the recorders that keep them, and --signal.
#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/signal/signal_reading.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// The reading options and --recorder, for a command's table of options.
std::vector<OptionSpec> signalOptionSpecs();

/// --signal with the reading options, of a command that takes a scenario.
std::vector<OptionSpec> recordOptionSpecs();

/// Returns the settings of --recorder, overridden by the options given. Throws CommandError.
SignalOptions signalOptionsOf(const Arguments& arguments);

/// Keeps the reading options of the words under the name of --save-recorder, where it is given. Throws
/// CommandError.
void saveRecorder(const Arguments& arguments);

/// Replaces the blow of the scenario by that of --signal, thinned to thinningError, unless --all-samples
/// keeps all of them, and keeps the remarks on its quality. It replaces a hammer of sections. Prints a
/// summary on stderr. Throws CommandError: usage if a reading option comes without --signal, unreadable
/// input, an open question.
void applySignal(ScenarioDocument& document, const Arguments& arguments, const std::string& path);

}  // namespace drillwave
