// SPDX-License-Identifier: GPL-3.0-or-later
// Options --method and --segments, which choose how one blow is solved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "core/blow/method.h"

namespace drillwave {

/// Returns the descriptions of the options --method and --segments.
std::vector<OptionSpec> methodOptionSpecs();

/// Returns the method given by --method and --segments. Without --method, returns `ofResult`, the method by
/// which the input was solved if it is a result. Otherwise returns the exact method. Throws CommandError
/// (usage).
MethodChoice methodChoice(const Arguments& arguments, const std::optional<MethodChoice>& ofResult = {});

/// Throws CommandError (usage) if the chosen method cannot solve this scenario; `path` names it in messages.
void checkMethodApplies(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

/// Returns the message "FILE: is for uniform rods; leave it out for a drill string", to be put after the name
/// of an option.
Message forUniformRods(const std::string& path);

/// Throws CommandError (usage) if the scenario is a drill string and the chosen method only solves uniform
/// rods.
void checkMethodOfString(const MethodChoice& choice, const Scenario& scenario, const std::string& path);

}  // namespace drillwave
