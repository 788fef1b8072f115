// SPDX-License-Identifier: GPL-3.0-or-later
// Reads records of strain gauges from tables.
#pragma once

#include <functional>
#include <istream>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/signal/signal_reading.h"
#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_question.h"
#include "core/text/message.h"

namespace drillwave {

/// Position of a strain gauge, and the table column with its signal (two columns for a pair of gauges).
struct GaugeChoice {
    std::string column;    ///< column of the signal, by name, or by number from 1
    std::string opposite;  ///< column of a gauge on the opposite side of the rod; empty for a single gauge
    double distance = 0;   ///< distance from the bit face [m]
    std::string name() const { return opposite.empty() ? column : column + "+" + opposite; }
    bool operator==(const GaugeChoice&) const = default;
};

/// Returns the reason why two gauges cannot be used together; empty if they can, or for a single gauge.
/// `places` are the positions of `gauges`, in the same order.
Message gaugePairProblem(const std::vector<GaugeChoice>& gauges, const std::vector<GaugePlace>& places);

/// Returns the positions of the gauges on rod or string, in the same order. Gauges that are not on a uniform
/// section are left out.
std::vector<GaugePlace> gaugePlaces(const Scenario& scenario, const std::vector<GaugeChoice>& gauges);

/// Record of strain gauges read from a table, or the reason why it could not be read.
struct GaugeReading {
    GaugeRecord record;
    /// Reason why the table cannot be read, such as a missing column; empty if it was read.
    Message problem;
    bool isWrongOption = false;  ///< whether the problem is in a command option rather than in the table
    /// Codes of facts that the table does not state, such as "unit" or "rate" (see SignalReading). The user
    /// must give them.
    std::vector<std::string> questions;
};

/// Returns the record read from a table of samples. Strains or stresses are converted to forces in the
/// section with the gauge. `places` are the positions of `gauges`, in the same order. In the record, gauges
/// are sorted by distance from the bit, nearest first.
/// `behind` names the column of a gauge on a second bar behind the specimen; empty if there is none.
GaugeReading readGauges(std::istream& in, const SignalOptions& options,
                        const std::vector<GaugeChoice>& gauges, const std::vector<GaugePlace>& places,
                        const std::stop_token& stop = {}, const std::string& behind = {});

}  // namespace drillwave
