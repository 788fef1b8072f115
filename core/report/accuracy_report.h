// SPDX-License-Identifier: GPL-3.0-or-later
// Report of error against computing time, for a uniform rod and for a drill string.
#pragma once

#include <string>

#include "core/report/json_value.h"
#include "core/study/proof/accuracy.h"
#include "core/study/proof/string_accuracy.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Returns the report as text for people: a table, the meaning of its columns, and the results of the checks.
std::string accuracyText(const Scenario& scenario, const Accuracy& accuracy,
                         const ReadingStyle& style = plainStyle());
std::string accuracyText(const Scenario& scenario, const StringAccuracy& accuracy,
                         const ReadingStyle& style = plainStyle());

/// Returns the report as one JSON object that begins with `head`; missing numbers are null.
std::string accuracyJson(const JsonHead& head, const Accuracy& accuracy);
std::string accuracyJson(const JsonHead& head, const StringAccuracy& accuracy);

/// Returns the report as CSV with one row for each method and resolution; missing numbers are empty cells.
std::string accuracyCsv(const Accuracy& accuracy);
std::string accuracyCsv(const StringAccuracy& accuracy);

}  // namespace drillwave
