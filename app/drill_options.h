// SPDX-License-Identifier: GPL-3.0-or-later
// Options of `drill`, read from their words, and the messages before anything is marched.
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

/// Returns SI unless --dimensionless. All functions here throw CommandError (usage) for a wrong option.
OutputUnits drillUnits(const Arguments& arguments);

/// --cells; `usual` without it.
int drillCells(const Arguments& arguments, int usual);

/// --histories A:B, of blows from 1 to those of the settings; nothing without it.
std::optional<BlowRange> drillHistories(const Arguments& arguments, const std::optional<std::string>& out,
                                        const DrillingSettings& settings);

/// Throws CommandError (invalid scenario) with a line for each problem where there are any.
void refuseDrill(const std::vector<Message>& problems, const std::string& path);

/// Cells times nodes that --work-limit permits.
double permittedDrillWork(const Arguments& arguments);

/// Throws CommandError (unsolved or failed) where it takes more cells times nodes than --work-limit permits.
void checkDrillWork(double work, const Arguments& arguments);

/// Prints on stderr which parts of the scenario have no effect here.
void remarkOnUnusedOfDrill(const Scenario& scenario, const std::string& path, const ReadingStyle& style);

}  // namespace drillwave
