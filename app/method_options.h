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

/// Throws CommandError (usage) if the method does not apply to this scenario, which `path` names.
void checkMethodApplies(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

/// Returns the message that a method or its option is not for the drill string that `path` names.
Message forUniformRods(const std::string& path);

/// Throws if a method for uniform rods was chosen for a drill string.
void checkMethodOfString(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

}  // namespace drillwave
