// SPDX-License-Identifier: GPL-3.0-or-later
// Report of error against run time, for a rod and for a drill string.
#pragma once

#include <string>

#include "core/report/json_value.h"
#include "core/study/proof/accuracy.h"
#include "core/study/proof/string_accuracy.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// A table for people, with what its columns mean and what the checks show.
std::string accuracyText(const Scenario& scenario, const Accuracy& accuracy,
                         const ReadingStyle& style = plainStyle());
std::string accuracyText(const Scenario& scenario, const StringAccuracy& accuracy,
                         const ReadingStyle& style = plainStyle());

/// Returns one JSON object behind its head; numbers that there are none of are null.
std::string accuracyJson(const JsonHead& head, const Accuracy& accuracy);
std::string accuracyJson(const JsonHead& head, const StringAccuracy& accuracy);

/// One row for each method and resolution; empty cells where there is no number.
std::string accuracyCsv(const Accuracy& accuracy);
std::string accuracyCsv(const StringAccuracy& accuracy);

}  // namespace drillwave
