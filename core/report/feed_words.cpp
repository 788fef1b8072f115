// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/feed_words.h"

#include <array>
#include <cmath>

#include "core/text/handy_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

std::string force(double newton) {
    return inHandyUnit(newton, Quantity::force, 4);
}

/// Where the installed thrust stands among the thresholds.
std::string standing(const FeedVerdict& verdict) {
    switch (verdict.feed) {
        case Feed::unknown:
            return {};
        case Feed::pushedBack:
            return "is below f I0 = " + force(verdict.balance);
        case Feed::penetrationLost:
            return "is below f I0 (1+e) = " + force(verdict.fullRate);
        case Feed::fullRate:
            return "is between f I0 (1+e) = " + force(verdict.fullRate) +
                   " and f I0 (1+2e) = " + force(verdict.returned);
        case Feed::backInTime:
            return "reaches f I0 (1+2e) = " + force(verdict.returned);
    }
    return {};
}

}  // namespace

std::string_view feedWord(Feed feed) {
    constexpr std::array<std::string_view, 5> words{"", "pushed back", "penetration lost",
                                                    "full rate, bit bounces", "bit back in time"};
    return words[static_cast<std::size_t>(feed)];
}

std::string_view feedAdvice(Feed feed) {
    switch (feed) {
        case Feed::unknown:
            return "No installed thrust is given: give drill.thrust to have it judged.";
        case Feed::pushedBack:
            return "The blows push the machine back from the rock. Raise the feed, or lower the percussion.";
        case Feed::penetrationLost:
            return "Penetration is lost: the bit bounces off the bottom between blows, many meet a bit that "
                   "is "
                   "not on the rock, and the string runs loose. Joints rattle, run hot and wear. Raise the "
                   "feed, or lower the percussion.";
        case Feed::fullRate:
            return "It drills at full rate, but the bit leaves the rock between blows and the joints are "
                   "hammered, unless the machine damps the rebound well.";
        case Feed::backInTime:
            return "The bit is back on the rock before the next blow, even if nothing damps the rebound. "
                   "Whether it is too much (friction, buckling, stalling of the rotation) is outside the "
                   "model.";
    }
    return {};
}

std::string feedForceText(const FeedForce& feed) {
    if (!feed.weight) return "installed thrust of " + force(feed.thrust);
    return "effective force of " + force(feed.effective()) + " (thrust " + force(feed.thrust) +
           (*feed.weight < 0 ? ", less " : ", and ") + force(std::abs(*feed.weight)) +
           " of weight along the hole)";
}

std::string feedSentence(const FeedVerdict& verdict) {
    const std::string advice(feedAdvice(verdict.feed));
    if (verdict.feed == Feed::unknown) return advice;
    return "The " + feedForceText(*verdict.force) + " " + standing(verdict) + ". " + advice;
}

std::string gapAtBlowSentence(const GapAtBlow& found) {
    switch (found.motion.kind) {
        case UndampedMotion::Kind::pushedBack:
            return "No steady motion of the bit is left.";
        case UndampedMotion::Kind::bouncing:
            if (!found.motion.stable)
                return "If nothing damps the rebound, the bit bounces without ever becoming steady, because "
                       "e is not below 1.";
            return (found.isBackInTime
                        ? "It may go on bouncing all the same if nothing damps the rebound; the bit is then "
                        : "If nothing damps the rebound, the bit is ") +
                   inHandyUnit(found.gap, Quantity::length, 3) + " (" + rounded(found.inD0, 3) +
                   " d0) off the rock when the hammer strikes.";
        case UndampedMotion::Kind::resting:
            return "Even if nothing damps the rebound, the bit has come to rest on the rock before every "
                   "blow.";
    }
    return {};
}

}  // namespace drillwave
