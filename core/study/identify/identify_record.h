// SPDX-License-Identifier: GPL-3.0-or-later
// Identifies the rock from one blow.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/identify_question.h"

namespace drillwave {

using ShowAnswer = std::function<void(RecordAnswer)>;

/// The answer of one blow, counted from 0, of a record of the question. `places` are those of its gauges, the
/// one near the bit first, as are the gauges of the record. Stopped, the answer is not to be used.
/// `showFirst` gets the answer of the bilinear law, unless that is rejected, while other laws are tried.
RecordAnswer identifyRecord(const IdentifyQuestion& question, const GaugeRecord& record,
                            const std::vector<GaugePlace>& places, std::size_t blow,
                            const std::stop_token& stop, const ShowAnswer& showFirst = {});

}  // namespace drillwave
