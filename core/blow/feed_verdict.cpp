// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/feed_verdict.h"

#include <array>

#include "core/blow/thrust.h"

namespace drillwave {

namespace {

Feed feedOf(const FeedVerdict& verdict) {
    if (!verdict.installed) return Feed::unknown;
    if (*verdict.installed < verdict.balance) return Feed::pushedBack;
    if (*verdict.installed < verdict.fullRate) return Feed::penetrationLost;
    return *verdict.installed < verdict.returned ? Feed::fullRate : Feed::backInTime;
}

}  // namespace

std::string_view name(Feed feed) {
    constexpr std::array<std::string_view, 5> names{"unknown", "pushed_back", "penetration_lost", "full_rate",
                                                    "back_in_time"};
    return names[static_cast<std::size_t>(feed)];
}

FeedVerdict feedVerdict(std::optional<double> installed, double balance, double fullRate, double returned) {
    FeedVerdict verdict{
        .installed = installed, .balance = balance, .fullRate = fullRate, .returned = returned};
    verdict.feed = feedOf(verdict);
    return verdict;
}

std::optional<FeedVerdict> judgeFeed(const Scenario& scenario, double cor) {
    const std::optional<double> balance = thrustNeeded(scenario, 0);
    if (!balance) return std::nullopt;
    return feedVerdict(scenario.drill.thrust, *balance, *thrustNeeded(scenario, cor),
                       *thrustNeeded(scenario, 2 * cor));
}

}  // namespace drillwave
