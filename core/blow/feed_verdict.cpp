// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/feed_verdict.h"

#include <algorithm>

#include "core/blow/thrust.h"
#include "core/blow/undamped_motion.h"
#include "core/model/blow_interval.h"
#include "core/model/blow_traits.h"
#include "core/model/scales.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

Feed feedOf(const std::optional<double>& force, const FeedThresholds& thresholds) {
    if (!force) return Feed::unknown;
    if (*force < thresholds.balance) return Feed::pushedBack;
    if (*force < thresholds.fullRate) return Feed::penetrationLost;
    if (*force < thresholds.returned) return Feed::fullRate;
    return *force < thresholds.resting ? Feed::backInTime : Feed::resting;
}

}  // namespace

std::string_view name(Feed feed) {
    static constexpr EnumNames<Feed> names{{{Feed::unknown, "unknown"},
                                            {Feed::pushedBack, "pushed_back"},
                                            {Feed::penetrationLost, "penetration_lost"},
                                            {Feed::fullRate, "full_rate"},
                                            {Feed::backInTime, "back_in_time"},
                                            {Feed::resting, "back_in_time"}}};
    return names[feed];
}

std::optional<double> FeedVerdict::effective() const {
    return force ? std::optional(force->effective()) : std::nullopt;
}

std::optional<double> FeedVerdict::margin() const {
    return force ? std::optional(force->marginOver(fullRate)) : std::nullopt;
}

FeedVerdict feedVerdict(const std::optional<FeedForce>& force, const FeedThresholds& thresholds) {
    FeedVerdict verdict{thresholds, force};
    verdict.feed = feedOf(verdict.effective(), thresholds);
    return verdict;
}

std::optional<FeedVerdict> judgeFeed(const Scenario& scenario, double cor, double transferred) {
    const std::optional<double> balance = thrustNeeded(scenario, 0, transferred);
    if (!balance) return std::nullopt;
    return feedVerdict(feedForceOf(scenario), {.balance = *balance,
                                               .fullRate = *thrustNeeded(scenario, cor, transferred),
                                               .returned = *thrustNeeded(scenario, 2 * cor, transferred),
                                               .resting = *balance * restingFeed(std::max(cor, 0.0))});
}

std::optional<GapAtBlow> gapAtBlow(const Scenario& scenario, double cor, double transferred) {
    const std::optional<double> balance = thrustNeeded(scenario, 0, transferred);
    const std::optional<FeedForce> force = feedForceOf(scenario);
    if (!balance || !force) return std::nullopt;
    GapAtBlow found{.motion = {}, .feed = force->effective() / *balance};
    const double rebound = std::max(cor, 0.0);
    found.motion = undampedMotion(found.feed, rebound);
    found.roundTrips = *roundTripsBetweenBlows(scenario);
    const Scales scales = scalesOf(scenario);
    const double velocity =
        isForced(scenario) ? scales.velocity : transferred * scales.impulse / chainProperties(scenario).mass;
    found.gap = found.motion.gap * velocity / *scenario.drill.blowFrequency;  // (T37)
    found.inD0 = gapHasPeriod(scenario) ? found.motion.gap * found.roundTrips
                                        : found.gap / scales.penetration;  // (T37)
    return found;
}

}  // namespace drillwave
