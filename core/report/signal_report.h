// SPDX-License-Identifier: GPL-3.0-or-later
// Reports on a measured record: text, row of a series, JSON, and a table of samples.
#pragma once

#include <span>
#include <string>

#include "core/signal/signal_reading.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// Measured record as read from a file, with the name of the file.
struct NamedReading {
    std::string file;
    SignalReading reading;
};

/// Returns one line for each fact read from a measured record, such as its columns and units. Open questions
/// are last, each with the option that answers it.
std::string signalText(const NamedReading& record, const ReadingStyle& style);

/// Returns a text table with one line per measured record: samples, rate, peak, impulse, offset, noise,
/// warnings and open questions.
std::string signalSeriesText(std::span<const NamedReading> records, const ReadingStyle& style);

/// Returns the JSON object of one measured record: how the file was read, and what was found in it.
JsonObject signalJson(const NamedReading& record);

/// Returns the recorded blow as CSV with the header "time [us],force [kN]". Requires a reading without open
/// questions.
std::string signalCsv(const SignalReading& reading);

}  // namespace drillwave
