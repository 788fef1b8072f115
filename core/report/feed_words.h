// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about the feed force: what single blows require, and what a sequence of blows gives. All reports
// use the same ones.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/blow/feed_estimate.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns a few words for the state of the feed force, for a table or a band of a plot, such as
/// "enough in all cases".
std::string_view feedWord(FeedState state);

/// Returns a sentence that states whether the feed force is enough. Example: "A feed force of 8 kN is enough
/// for a single blow at any gap (7.25 kN required)." Without an estimate, the sentence says which input is
/// missing. Forces have enough digits to distinguish the required from the installed one.
Message requiredFeedMessage(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                            const ReadingStyle& style = plainStyle());

/// Returns one or two sentences on the required feed force. The first is that of requiredFeedMessage(). If
/// there is an estimate, a second one names the command or page for consecutive blows.
std::vector<Message> estimateSentences(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                                       const ReadingStyle& style = plainStyle());
/// Returns the sentences on the required feed force (see estimateSentences()) as one paragraph, in the
/// language of the reader.
std::string estimateText(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                         const ReadingStyle& style = plainStyle());

/// Returns a sentence with the remedy for a feed force below what this blow requires. Example: "For this
/// blow, the feed force must be at least 4.4 kN at 60 Hz, or the blow frequency at most 48 Hz with the
/// present feed force."
Message feedRemedy(const FeedEstimate& estimate, const ReadingStyle& style = plainStyle());

/// Returns a sentence on how much the feed force must be raised, as estimated from single blows. It covers
/// this blow and every gap between bit and rock (or rigid rock). If the force is enough, the sentence says
/// so. Empty without an installed feed force, or if the estimate does not apply.
Message moreFeedMessage(const FeedEstimate& estimate, const ReadingStyle& style = plainStyle());

/// Sentence on what the model neglects. Reports print it once, next to advice to raise the feed force.
inline constexpr const char* feedLimitsOfModel =
    translatable("Friction, rotation and buckling are not modelled.");

/// Returns the name of the tool that computes sequences of blows, for use within a sentence. It is "`drill`"
/// for the command line, and "the page "Drilling"" in print and in the window.
Message drillingWords(const ReadingStyle& style);

/// Returns the feed force in words, such as "installed feed force 8 kN". If an inclination is given, the text
/// has the effective feed force and its parts: the installed force and the weight along the hole.
std::string feedForceText(const FeedForce& feed, const ReadingStyle& style = plainStyle());

/// Returns the label of a case of the required feed force: "this blow", "95 % of all gaps", "rigid rock" or
/// "fully elastic rock (gamma = 1), worst gap".
const char* labelOf(ThrustCase which);

}  // namespace drillwave
