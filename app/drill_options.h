// SPDX-License-Identifier: GPL-3.0-or-later
// Options of the command `drill` (many blows in sequence), and the checks before the computation starts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/blow/outputs.h"
#include "core/model/scenario.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/rows/output_column.h"

namespace drillwave {

/// Returns the units of the output: SI, or dimensionless with --dimensionless. Throws CommandError (usage) if
/// --si is also given.
OutputUnits drillUnits(const Arguments& arguments);

/// Returns the number of time steps (cells) per duration t0 of the hammer force, given by --cells; `usual`
/// without the option.
int drillCells(const Arguments& arguments, int usual);

/// Returns the blows A to B of --histories A:B, whose histories are written; nothing without the option.
/// Blows are numbered from 1 to settings.blows. `out` is the value of -o, which must be a folder.
std::optional<BlowRange> drillHistories(const Arguments& arguments, const std::optional<std::string>& out,
                                        const DrillingSettings& settings);

/// Throws CommandError (invalid scenario) with one line for each of the `problems` of the scenario `path`;
/// does nothing if there are none.
void refuseDrill(const std::vector<Message>& problems, const std::string& path);

/// Returns the largest work that --work-limit permits for a sequence of many blows. Work is the number of
/// time steps (cells) times the number of nodes (ends of sections).
double permittedDrillWork(const Arguments& arguments);

/// Throws CommandError (unsolved or failed) if a sequence of blows needs more work than --work-limit permits.
/// `work` is the number of time steps (cells) times the number of nodes (ends of sections).
void checkDrillWork(double work, const Arguments& arguments);

/// Prints on stderr the parameters of the scenario that have no effect on many blows.
void remarkOnUnusedOfDrill(const Scenario& scenario, const std::string& path, const ReadingStyle& style);

}  // namespace drillwave
