// SPDX-License-Identifier: GPL-3.0-or-later
// A study of designs as tables.
#pragma once

#include <string>

#include "core/report/design_report.h"

namespace drillwave {

/// A row for each design; of the Pareto set alone. The columns of the choices, and what keeps the energy, set
/// a design again.
std::string designsCsv(const DesignReport& report);
std::string paretoCsv(const DesignReport& report);
/// A row for each output and uncertain number.
std::string sensitivityCsv(const DesignReport& report);
/// A row for each aim, its keys first: a table of cases of the base.
std::string worstCsv(const DesignReport& report);

}  // namespace drillwave
