// SPDX-License-Identifier: GPL-3.0-or-later
// The command `drill --scan`: sequences of blows for each value of a parameter.
#pragma once

#include <string>

#include "app/arguments.h"
#include "app/command_error.h"
#include "app/drawing.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Computes a sequence of blows for each value of the scanned parameter, writes and prints the results, and
/// returns the exit code. `document` must already contain the values of options that set scenario keys.
/// Throws CommandError.
ExitCode runDrillScan(const Arguments& arguments, const ScenarioDocument& document, const std::string& path,
                      const Drawing* drawing);

}  // namespace drillwave
