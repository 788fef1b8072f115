// SPDX-License-Identifier: GPL-3.0-or-later
// Records of strain gauges through the one reader of tables.
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

/// Where a gauge is, and which column of the table it is.
struct GaugeChoice {
    std::string column;    ///< by name, or number from 1
    std::string opposite;  ///< on the opposite side; empty for one gauge
    double distance = 0;   ///< from the bit face [m]
    std::string name() const { return opposite.empty() ? column : column + "+" + opposite; }
    bool operator==(const GaugeChoice&) const = default;
};

/// Why two gauges cannot be used together; empty for one gauge, or where they can. `places` are those of
/// `gauges`.
Message gaugePairProblem(const std::vector<GaugeChoice>& gauges, const std::vector<GaugePlace>& places);

/// A record, or why there is none.
struct GaugeReading {
    GaugeRecord record;
    Message problem;                     ///< the table cannot be read, or a column is not there
    bool isWrongOption = false;          ///< the problem is one of an option
    std::vector<std::string> questions;  ///< what the table leaves open, as of SignalReading
};

/// Reads the columns of the gauges as forces of their section; they come out in the order of their distance
/// from the bit. `places` are those of `gauges`. `behind` is a column of a gauge on a like bar behind the
/// specimen; empty where there is none.
GaugeReading readGauges(std::istream& in, const SignalOptions& options,
                        const std::vector<GaugeChoice>& gauges, const std::vector<GaugePlace>& places,
                        const std::stop_token& stop = {}, const std::string& behind = {});

}  // namespace drillwave
