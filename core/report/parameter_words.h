// SPDX-License-Identifier: GPL-3.0-or-later
// How a parameter is called by people, in parts that a window can say in the user's language.
#pragma once

#include <string_view>

#include "core/model/parameter.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// "stiffness", "length of hammer 1", "force of corner 2": the label, without the symbol.
Message labelMessage(const Parameter& parameter);

/// The same with the words of the section that it is of, "length of 2nd rod", where it is of one and there
/// are any.
Message labelMessage(const Parameter& parameter, const Message& section);
/// With the words that tables of the sections of the scenario have.
Message labelMessage(const Parameter& parameter, const Scenario& scenario);

/// "stiffness k", as in the form: the label, and behind it the symbol as it is written there, where it has
/// one.
Message titleMessage(const Parameter& parameter, std::string_view symbol);

/// How a sentence names what is to be given: by the key of a file for a command, and in print and in a window
/// by the title of the field, as the form has it.
Message fieldMessage(const Parameter& parameter, const ReadingStyle& style);

}  // namespace drillwave
