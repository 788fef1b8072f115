// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts with which shells complete the words of a command line: commands, options and what these take.
#pragma once

#include <string>

namespace drillwave {

std::string bashCompletion();
std::string zshCompletion();
std::string fishCompletion();

}  // namespace drillwave
