// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/feed_decision.h"

#include <algorithm>

#include "core/blow/feed_force.h"
#include "core/model/blow_traits.h"

namespace drillwave {

namespace {

FeedDecision::Kind kindOf(const FeedVerdict& verdict, const std::optional<WidestNeed>& widest) {
    using Kind = FeedDecision::Kind;
    if (!verdict.force) return Kind::noThrust;
    if (verdict.isTooLittle()) return Kind::notEnough;
    const bool isWide = widest && verdict.force->effective() >= widest->thrust;
    return isWide ? Kind::enough : Kind::enoughThisBlow;
}

}  // namespace

double FeedDecision::thrustFor(double needed) const {
    return std::max(needed - weight, 0.0);
}

double FeedDecision::frequencyFor(double needed) const {
    return force && needed > 0 ? frequency * std::max(force->effective(), 0.0) / needed : 0;
}

FeedDecision decideFeed(const Scenario& scenario, const std::optional<FeedVerdict>& verdict,
                        std::optional<WidestNeed> widest) {
    using Kind = FeedDecision::Kind;
    FeedDecision decision;
    decision.force = feedForceOf(scenario);
    if (!verdict) {
        decision.kind = hasUnits(scenario) ? Kind::noFrequency : Kind::noUnits;
        return decision;
    }
    if (!widest && !gapHasPeriod(scenario)) {
        const double rigid = 2 * verdict->balance;  // f I0 (1+e), e = 1
        const bool isRigid = rigid >= verdict->fullRate;
        widest = WidestNeed{.which = isRigid ? ThrustCase::rigidRock : ThrustCase::scenario,
                            .thrust = std::max(rigid, verdict->fullRate)};
    }
    decision.kind = kindOf(*verdict, widest);
    decision.weight = weightAlongHole(scenario).value_or(0);
    decision.frequency = *scenario.drill.blowFrequency;
    decision.need = verdict->fullRate;
    decision.widest = widest;
    return decision;
}

}  // namespace drillwave
