// SPDX-License-Identifier: GPL-3.0-or-later
// Names of parameters for people, in parts that the window can translate.
#pragma once

#include <string_view>

#include "core/model/parameter.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the label of a parameter without its symbol, such as "stiffness", "length of hammer 1" or "force
/// of corner 2" (of the rock law).
Message labelMessage(const Parameter& parameter);

/// Returns the label of a parameter, followed by its section in the words `section`, such as "length of 2nd
/// rod". If it belongs to no section, returns the plain label.
Message labelMessage(const Parameter& parameter, const Message& section);
/// Returns the label of a parameter. For a parameter of a section, the label names the section as tables of
/// the scenario do, such as "length of 2nd rod".
Message labelMessage(const Parameter& parameter, const Scenario& scenario);

/// Returns the title of a form field, such as "stiffness k": the label of the parameter and `symbol`. Only
/// the label if `symbol` is empty.
Message titleMessage(const Parameter& parameter, std::string_view symbol);

/// Returns the name of a parameter for a sentence that asks the user to enter it. It is the key for the
/// command line, and the title of the form field in print and in the window.
Message fieldMessage(const Parameter& parameter, const ReadingStyle& style);

}  // namespace drillwave
