// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the feed force in words: the same wherever it is told.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/blow/feed_decision.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// A few words for a table: "penetration lost". Empty where no thrust is given.
std::string_view feedWord(Feed feed);

/// The sentence to act on: "8 kN is enough at every gap up to 66.1 Hz." It tells what is missing where that
/// cannot be said. Needs are rounded up and frequencies down, to as many digits as tell them from what is.
Message feedDecisionMessage(const FeedDecision& decision, const ReadingStyle& style = plainStyle());
/// The same in the language of the reader.
std::string feedDecisionText(const FeedDecision& decision, const ReadingStyle& style = plainStyle());

/// What the feed means at the rig, without numbers: a pattern of a Message.
const char* feedAdvice(Feed feed);

/// The same, with where the bit is when the hammer strikes if nothing damps the rebound.
Message feedMeaning(Feed feed, const std::optional<GapAtBlow>& found,
                    const ReadingStyle& style = plainStyle());

/// What follows dampers and waves from blow to blow, in the middle of a sentence: the command, in print and
/// in a window its page.
Message drillingWords(const ReadingStyle& style);

/// "installed thrust of 8 kN"; where an inclination is given, the effective force and its parts.
std::string feedForceText(const FeedForce& feed, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
