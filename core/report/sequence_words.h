// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about a sequence of blows (penetration and rate with errors, contact share, gap) and about a
// scan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/study/drilling/sequence.h"
#include "core/study/scan/scan_comparison.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns a value with its error, rounded to the digits that the error justifies, such as "2.07 +- 0.02 mm".
/// `si` and `error` (≥ 0) are in SI units.
std::string withError(double si, const std::optional<double>& error, Quantity quantity,
                      const ReadingStyle& style = plainStyle());

/// Returns the feed model in words, such as "a constant force" or "a dashpot of 6.3 kN s/m and a spring of
/// 6.3 MN/m".
Message feedModelWords(const Scenario& scenario, const ReadingStyle& style = plainStyle());

/// Returns sentences on the results of a sequence: penetration and rate, a warning if they are too uncertain,
/// contact share, and the feed model. If there is no result, they say why.
std::vector<Message> sequenceSentences(const DrillingResult& result,
                                       const ReadingStyle& style = plainStyle());
/// Returns the sentences of sequenceSentences() as one paragraph, in the language of the reader.
std::string sequenceText(const DrillingResult& result, const ReadingStyle& style = plainStyle());

/// Returns sentences that say which value of a scan has the highest penetration rate, and by how much its
/// rate exceeds that of `present`. If the errors are too large to decide, the sentences say so. Empty if no
/// value has statistics, or if the scanned values are words.
std::vector<Message> scanSentences(const DrillingScan& scan, const std::optional<Sequence>& present,
                                   const ReadingStyle& style = plainStyle());

}  // namespace drillwave
