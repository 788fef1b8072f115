// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of a record: text, a row of a series, JSON and a table of samples.
#pragma once

#include <span>
#include <string>

#include "core/signal/signal_reading.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// A reading and the name of its file.
struct NamedReading {
    std::string file;
    SignalReading reading;
};

/// One line for each fact, questions last with the option that answers each.
std::string signalText(const NamedReading& record, const ReadingStyle& style);

/// One row for each record: what was read, and its quality.
std::string signalSeriesText(std::span<const NamedReading> records, const ReadingStyle& style);

/// The object of one record.
JsonObject signalJson(const NamedReading& record);

/// Returns the blow as CSV, "time [us],force [kN]". Requires a reading without questions.
std::string signalCsv(const SignalReading& reading);

}  // namespace drillwave
