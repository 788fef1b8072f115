// SPDX-License-Identifier: GPL-3.0-or-later
// --method and --segments.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/blow/method.h"

namespace drillwave {

/// The two options, for a command's table of options.
std::vector<OptionSpec> methodOptionSpecs();

/// Returns the method given by the options; without --method that of a result which is solved again, as
/// loadScenarioInput() found it, or else exact. Throws CommandError (usage).
MethodChoice methodChoice(const Arguments& arguments, const std::optional<MethodChoice>& ofResult = {});

/// Throws CommandError (usage) if the method says nothing about this scenario, which `path` names.
void checkMethodApplies(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

/// That a method or its option is not for the drill string that `path` names.
Message forUniformRods(const std::string& path);

/// Throws where a drill string was asked for by a method for uniform rods.
void checkMethodOfString(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

}  // namespace drillwave
