// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about a sequence of blows: penetration and rate with errors, contact, gap; and about a scan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/study/drilling/sequence.h"
#include "core/study/scan/scan_comparison.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// A number with its error to the digits that the error leaves: "2.07 +- 0.02 mm". `error` ≥ 0.
std::string withError(double si, const std::optional<double>& error, Quantity quantity,
                      const ReadingStyle& style = plainStyle());

/// "a constant force", "a damper of 6.3 kN s/m and 6.3 MN/m".
Message feedModelWords(const Scenario& scenario, const ReadingStyle& style = plainStyle());

/// Sentences on what a sequence gives, or why there is nothing: penetration and rate, contact, what is not
/// resolved, the model of the feed.
std::vector<Message> sequenceSentences(const DrillingResult& result,
                                       const ReadingStyle& style = plainStyle());
/// In one paragraph, in the language of the reader.
std::string sequenceText(const DrillingResult& result, const ReadingStyle& style = plainStyle());

/// The value that gives the most, where the errors tell it, and by how much it is above `present`; empty
/// without values, and of a parameter that is a word.
std::vector<Message> scanSentences(const DrillingScan& scan, const std::optional<Sequence>& present,
                                   const ReadingStyle& style = plainStyle());

}  // namespace drillwave
