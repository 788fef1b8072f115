// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time as the accuracy command tells it.
#pragma once

#include <QByteArray>
#include <string>

#include "core/model/scenario.h"
#include "core/study/proof/accuracy.h"

namespace drillwave {

/// A table for people, with what its columns mean and what the checks show.
std::string accuracyText(const Scenario& scenario, const Accuracy& accuracy);

/// One JSON object, with the text that gives the scenario again; numbers that there are none of are null.
QByteArray accuracyJson(const Scenario& scenario, const std::string& scenarioText, const Accuracy& accuracy);

/// One row for each method and resolution; empty cells where there is no number.
std::string accuracyCsv(const Accuracy& accuracy);

}  // namespace drillwave
