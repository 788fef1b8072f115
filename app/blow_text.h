// SPDX-License-Identifier: GPL-3.0-or-later
// One solved blow told to people.
#pragma once

#include <string>

#include "core/blow/blow.h"

namespace drillwave {

/// A summary for people, rounded to six digits. Requires a solved blow.
std::string reportText(const Blow& blow);

}  // namespace drillwave
