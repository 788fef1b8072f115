// SPDX-License-Identifier: GPL-3.0-or-later
// Times of a recording as the head of its table states them: when it began, and its sampling rate.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/signal/detected_table.h"

namespace drillwave {

// Times of day and dates with one, as recorders and spreadsheets write them.

/// A time of day, counted from an unknown midnight where there is no date. Seconds are kept apart from their
/// fraction, so that microseconds of a date are not lost.
struct TimeStamp {
    std::int64_t seconds = 0;
    double fraction = 0;  ///< [s], from 0 to 1
    bool hasDate = false;
};

/// Reads "09:11:02.0001", "09:11:02,0001", "11:02.5" (minutes and seconds), "9:11:02 PM", each also after a
/// date and a blank or T: "2024-03-12T09:11:02Z", "12.03.2024 09:11:02", "03/12/2024 9:11:02 AM". In "03/12"
/// the month is taken to be first; it matters only where a record passes midnight.
std::optional<TimeStamp> timeStamp(std::string_view cell);

/// How much later `stamp` is than `first` [s]. Without dates the second is on the next day where it would be
/// more than half a day earlier.
double secondsSince(const TimeStamp& first, const TimeStamp& stamp);

// Sampling rates, intervals and units that the lines above or beside the samples state.

/// Looks through the lines above the samples, and through the cells beside the first samples, for a rate or
/// an interval with its unit ("sampling rate: 5 MHz", "Sample Interval",1e-6,s, "Abtastrate [kHz];5000") and
/// for the units of the axes ("Vertical Units",V), and puts them where the table has none of its own.
void readStatedRate(std::span<const std::string> lines, DetectedTable& table);

}  // namespace drillwave
