// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about the feed: what single blows require, what a sequence of blows does. The same wherever they
// are printed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// A few words for a table or a band of a plot: "below required".
std::string_view feedWord(FeedState state);

/// One sentence on the case that decides: "8 kN covers every single blow (7.25 kN required)." It says what is
/// missing where there is no estimate. Forces have as many digits as tell the required from the installed
/// one.
Message requiredFeedMessage(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                            const ReadingStyle& style = plainStyle());

/// The same, and while no sequence was computed what computes it.
std::vector<Message> estimateSentences(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                                       const ReadingStyle& style = plainStyle());
/// In one paragraph, in the language of the reader.
std::string estimateText(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                         const ReadingStyle& style = plainStyle());

/// Returns the remedy where the feed is below what this blow requires: "At least 4.4 kN at 60 Hz, or at most
/// 48 Hz, would cover this blow."
Message feedRemedy(const FeedEstimate& estimate, const ReadingStyle& style = plainStyle());

/// Says how much more feed brings, as far as single blows tell it: what covers this blow and every gap, or
/// that they need no more. Empty where no feed is installed and where the estimate does not apply.
Message moreFeedMessage(const FeedEstimate& estimate, const ReadingStyle& style = plainStyle());

/// Stands once beside every statement on more feed.
inline constexpr const char* feedLimitsOfModel =
    translatable("Friction, rotation and buckling are not modelled.");

/// Names what follows dampers and waves from blow to blow, in the middle of a sentence: the command, in print
/// and in a window its page.
Message drillingWords(const ReadingStyle& style);

/// "installed thrust of 8 kN"; where an inclination is given, the effective force and its parts.
std::string feedForceText(const FeedForce& feed, const ReadingStyle& style = plainStyle());

/// Returns the label of a case in tables: "this blow", "95 % of all gaps", "rigid rock", "elastic rock, worst
/// gap".
const char* labelOf(ThrustCase which);

}  // namespace drillwave
