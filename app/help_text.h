// SPDX-License-Identifier: GPL-3.0-or-later
// What --help prints.
#pragma once

#include <string>

#include "app/command.h"

namespace drillwave {

/// Help of the whole program.
std::string programHelp();

/// Help of one subcommand.
std::string commandHelp(const Command& command);

}  // namespace drillwave
