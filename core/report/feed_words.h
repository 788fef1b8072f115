// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the feed force in words: the same wherever it is told.
#pragma once

#include <string>
#include <string_view>

#include "core/blow/feed_verdict.h"

namespace drillwave {

/// A word or two for a table: "penetration lost". Empty where no thrust is given.
std::string_view feedWord(Feed feed);

/// What that means at the rig and what to do, without numbers.
std::string_view feedAdvice(Feed feed);

/// "installed thrust of 8 kN"; where an inclination is given, the effective force and its parts.
std::string feedForceText(const FeedForce& feed);

/// The verdict in words, with its thresholds: "The installed thrust of 4 kN is below f I0 (1+e) = 4.37 kN.
/// …".
std::string feedSentence(const FeedVerdict& verdict);

/// Where the bit is when the hammer strikes if nothing damps the rebound, in a sentence.
std::string gapAtBlowSentence(const GapAtBlow& found);

}  // namespace drillwave
