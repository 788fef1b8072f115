// SPDX-License-Identifier: GPL-3.0-or-later
// One solved blow with all that is reported about it, and the report for programs.
#pragma once

#include <QByteArray>
#include <string>
#include <vector>

#include "core/blow/method.h"
#include "core/model/alerts.h"
#include "core/model/scenario.h"
#include "core/model/validation.h"
#include "core/wave/impact.h"

namespace drillwave {

/// All that is reported about one blow.
struct BlowReport {
    Scenario scenario;
    Impact impact;                      ///< solved with Detail::summary or more
    double runTime = 0;                 ///< of the solve alone [s]
    MethodChoice choice;                ///< how it was solved
    std::vector<Alert> alerts() const;  ///< of the scenario, and of the result if there is one
};

/// The JSON object of a blow (files §5): results dimensionless and, where the scenario has units, in SI with
/// the unit of each; and the scenario as the text that gives them again (completeScenarioText()). Numbers
/// read back exactly; they are null where the case could not be solved.
QByteArray reportJson(const BlowReport& report, const std::string& scenarioText);

}  // namespace drillwave
