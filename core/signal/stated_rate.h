// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling rates, intervals and units that the lines above or beside the samples state.
#pragma once

#include <span>
#include <string>

#include "core/signal/detected_table.h"

namespace drillwave {

/// Looks through the lines above the samples, and through the cells beside the first samples, for a rate or
/// an interval with its unit ("sampling rate: 5 MHz", "Sample Interval",1e-6,s, "Abtastrate [kHz];5000") and
/// for the units of the axes ("Vertical Units",V), and puts them where the table has none of its own.
void readStatedRate(std::span<const std::string> lines, DetectedTable& table);

}  // namespace drillwave
