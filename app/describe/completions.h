// SPDX-License-Identifier: GPL-3.0-or-later
// Shell scripts that complete the words of a command line: commands, options and their values.
#pragma once

#include <string>

namespace drillwave {

std::string bashCompletion();
std::string zshCompletion();
std::string fishCompletion();

}  // namespace drillwave
