// SPDX-License-Identifier: GPL-3.0-or-later
// One solved blow told to people.
#pragma once

#include <string>

#include "ui/export/blow_report.h"

namespace drillwave {

/// A summary for people, rounded to six digits. Requires a solved impact.
std::string reportText(const BlowReport& report);

}  // namespace drillwave
