// SPDX-License-Identifier: GPL-3.0-or-later
// Identification of the rock from one blow.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/identify_question.h"

namespace drillwave {

/// Callback that receives the preliminary result of a record, before other rock laws are tried.
using ShowAnswer = std::function<void(RecordAnswer)>;

/// Identifies the rock from one blow (index from 0) of a record and returns the result. `places` are the
/// positions of the gauges, nearest to the bit first. `showFirst` receives the result of the bilinear law,
/// unless that is rejected, before other laws are tried. After a stop request, the result must not be used.
RecordAnswer identifyRecord(const IdentifyQuestion& question, const GaugeRecord& record,
                            const std::vector<GaugePlace>& places, std::size_t blow,
                            const std::stop_token& stop, const ShowAnswer& showFirst = {});

}  // namespace drillwave
