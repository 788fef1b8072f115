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

/// Callback that receives a preliminary result of a record.
using ShowAnswer = std::function<void(RecordAnswer)>;

/// Returns the result of one blow (index from 0) of a record. `places` are the positions of its gauges,
/// nearest to the bit first, in the order of the record. After a stop request, the result must not be used.
/// `showFirst` receives the result of the bilinear law, unless that is rejected, before other laws are tried.
RecordAnswer identifyRecord(const IdentifyQuestion& question, const GaugeRecord& record,
                            const std::vector<GaugePlace>& places, std::size_t blow,
                            const std::stop_token& stop, const ShowAnswer& showFirst = {});

}  // namespace drillwave
