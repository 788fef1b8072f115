// SPDX-License-Identifier: GPL-3.0-or-later
// A study of designs as JSON.
#pragma once

#include <string>

#include "core/report/design_report.h"

namespace drillwave {

/// One JSON object, SI or dimensionless as the scenario is.
std::string designJson(const DesignReport& report);

}  // namespace drillwave
