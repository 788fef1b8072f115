// SPDX-License-Identifier: GPL-3.0-or-later
// Start time and sampling rate of a recording, as stated in the head of its table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/signal/detected_table.h"

namespace drillwave {

// Times of day, with or without a date, as recorders and spreadsheets write them.

/// Time of day; without a date it counts from an unknown midnight. Whole seconds and their fraction are
/// stored separately, so that times with a date are also precise to less than a microsecond.
struct TimeStamp {
    std::int64_t seconds = 0;
    double fraction = 0;  ///< fraction of a second [s], 0 … 1
    bool hasDate = false;
};

/// Returns the time in a cell of a table, or nullopt if the cell is no time. Times are "09:11:02.0001",
/// "09:11:02,0001", "11:02.5" (minutes and seconds) or "9:11:02 PM". A date and a blank or T may precede:
/// "2024-03-12T09:11:02Z", "12.03.2024 09:11:02", "03/12/2024 9:11:02 AM". In "03/12" the first number is
/// assumed to be the month. A wrong assumption matters only for a record that passes midnight.
std::optional<TimeStamp> timeStamp(std::string_view cell);

/// Returns the time from `first` to `stamp` [s]. Without dates, a stamp more than half a day earlier than
/// `first` is assumed to be on the next day.
double secondsSince(const TimeStamp& first, const TimeStamp& stamp);

// Sampling rates, intervals and units that are stated above or beside the samples.

/// Adds to `table` facts from the lines above the samples, and from cells beside the first samples. These are
/// a sampling rate or interval with its unit ("sampling rate: 5 MHz", "Sample Interval",1e-6,s, "Abtastrate
/// [kHz];5000"), and units of the axes ("Vertical Units",V). Facts that the table already has remain.
void readStatedRate(std::span<const std::string> lines, DetectedTable& table);

}  // namespace drillwave
