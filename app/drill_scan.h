// SPDX-License-Identifier: GPL-3.0-or-later
// `drill --scan`: many blows over the values of a parameter.
#pragma once

#include <string>

#include "app/arguments.h"
#include "app/command_error.h"
#include "app/drawing.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Marches, writes and prints a scan of a file whose short options are set already. Throws CommandError.
ExitCode runDrillScan(const Arguments& arguments, const ScenarioDocument& document, const std::string& path,
                      const Drawing* drawing);

}  // namespace drillwave
