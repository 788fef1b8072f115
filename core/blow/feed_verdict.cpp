// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/feed_verdict.h"

#include <array>

#include "core/blow/thrust.h"
#include "core/model/blow_interval.h"
#include "core/model/scales.h"

namespace drillwave {

namespace {

Feed feedOf(const std::optional<double>& force, const FeedThresholds& thresholds) {
    if (!force) return Feed::unknown;
    if (*force < thresholds.balance) return Feed::pushedBack;
    if (*force < thresholds.fullRate) return Feed::penetrationLost;
    return *force < thresholds.returned ? Feed::fullRate : Feed::backInTime;
}

}  // namespace

std::string_view name(Feed feed) {
    constexpr std::array<std::string_view, 5> names{"unknown", "pushed_back", "penetration_lost", "full_rate",
                                                    "back_in_time"};
    return names[static_cast<std::size_t>(feed)];
}

std::optional<double> FeedVerdict::effective() const {
    return force ? std::optional(force->effective()) : std::nullopt;
}

std::optional<double> FeedVerdict::margin() const {
    return force ? std::optional(force->effective() / fullRate - 1) : std::nullopt;
}

FeedVerdict feedVerdict(const std::optional<FeedForce>& force, const FeedThresholds& thresholds) {
    FeedVerdict verdict{thresholds, force};
    verdict.feed = feedOf(verdict.effective(), thresholds);
    return verdict;
}

std::optional<FeedVerdict> judgeFeed(const Scenario& scenario, double cor) {
    const std::optional<double> balance = thrustNeeded(scenario, 0);
    if (!balance) return std::nullopt;
    return feedVerdict(feedForceOf(scenario),
                       {*balance, *thrustNeeded(scenario, cor), *thrustNeeded(scenario, 2 * cor)});
}

std::optional<GapAtBlow> gapAtBlow(const Scenario& scenario, double cor) {
    const std::optional<double> balance = thrustNeeded(scenario, 0);
    const std::optional<FeedForce> force = feedForceOf(scenario);
    if (!balance || !force) return std::nullopt;
    GapAtBlow found{.motion = {}, .feed = force->effective() / *balance};
    found.motion = undampedMotion(found.feed, cor);
    found.isBackInTime = found.feed >= 1 + 2 * cor;  // (T35)
    found.roundTrips = *roundTripsBetweenBlows(scenario);
    found.gap = found.motion.gap * scalesOf(scenario).velocity / *scenario.drill.blowFrequency;  // (T37)
    found.inD0 = found.motion.gap * found.roundTrips;                                            // (T37)
    return found;
}

}  // namespace drillwave
