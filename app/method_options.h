// SPDX-License-Identifier: GPL-3.0-or-later
// Options --method and --segments, which choose how one blow is solved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/blow/method.h"

namespace drillwave {

/// Returns the options --method and --segments, for a command's table of options.
std::vector<OptionSpec> methodOptionSpecs();

/// Returns the method given by --method and --segments. Without --method it is `ofResult`, the method of a
/// result that is solved again, or else the exact method. Throws CommandError (usage).
MethodChoice methodChoice(const Arguments& arguments, const std::optional<MethodChoice>& ofResult = {});

/// Throws CommandError (usage) if the chosen method cannot solve this scenario; `path` names it in messages.
void checkMethodApplies(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

/// Returns the message that an option is only for uniform rods, while `path` is a drill string.
Message forUniformRods(const std::string& path);

/// Throws CommandError (usage) if the scenario is a drill string and the chosen method only solves uniform
/// rods.
void checkMethodOfString(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

}  // namespace drillwave
