// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/feed_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/model/scales.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

constexpr double standardGravity = 9.80665;  // [m/s²]

/// Returns the sine of an angle in degrees, exact where the hole is level or plumb.
double sineOf(double degrees) {
    return std::abs(degrees) == 90 ? std::copysign(1.0, degrees) : std::sin(degrees * std::numbers::pi / 180);
}

/// Relative difference of equal forces: adding and removing a weight leaves an error of this size.
constexpr double rounding = 1e-12;

ThrustNeed needOf(const Scenario& scenario, const Estimate& cor, double transferred) {
    ThrustNeed need{.cor = cor,
                    .thrust = *thrustNeeded(scenario, cor.value, transferred),
                    .thrustUndamped = *thrustNeeded(scenario, 2 * cor.value, transferred),
                    .margin = {},
                    .frequencyLimit = {},
                    .gapAtBlow = gapAtBlow(scenario, cor.value, transferred)};
    if (const std::optional<FeedForce> force = feedForceOf(scenario)) {
        need.margin = force->marginOver(need.thrust);
        need.frequencyLimit = *scenario.drill.blowFrequency * std::max(force->effective(), 0.0) / need.thrust;
    }
    return need;
}

}  // namespace

std::optional<FeedForce> feedForceOf(const Scenario& scenario) {
    if (!scenario.drill.thrust) return std::nullopt;
    return FeedForce{.thrust = *scenario.drill.thrust, .weight = weightAlongHole(scenario)};
}

std::optional<double> weightAlongHole(const Scenario& scenario) {
    if (!hasUnits(scenario) || !scenario.drill.inclination) return std::nullopt;
    const double carried = chainProperties(scenario).mass;
    const double mass = carried + scenario.drill.machineMass.value_or(0);
    return mass * standardGravity * sineOf(*scenario.drill.inclination);
}

std::optional<double> thrustNeeded(const Scenario& scenario, double cor, double transferred) {
    if (!thrustProblem(scenario).isEmpty()) return std::nullopt;
    return *scenario.drill.blowFrequency * pulseImpulse(scenario) * transferred * (1 + std::max(cor, 0.0));
}

Message thrustProblem(const Scenario& scenario) {
    return frequencyProblem(scenario, translatable("the feed force"));
}

Message thrustMarginProblem(const Scenario& scenario) {
    if (!gapPeriod(scenario))
        return translatable("the feed force margin is known only for uniform rods (`drillwave: 1`)");
    if (const Message problem = thrustProblem(scenario); !problem.isEmpty()) return problem;
    if (!scenario.drill.thrust)
        return translatable(
            "the feed force margin needs drill.thrust; give it in the scenario or with --set");
    return {};
}

Message frequencyProblem(const Scenario& scenario, const char* what) {
    if (!hasUnits(scenario))
        return {translatable("%1 needs a scenario in physical units; this one is given by its "
                             "dimensionless groups"),
                {what}};
    if (!scenario.drill.blowFrequency)
        return {translatable("%1 needs drill.blow_frequency; give it in the scenario or with --set"), {what}};
    return {};
}

UndampedMotion undampedMotion(double feed, double cor) {
    using Kind = UndampedMotion::Kind;
    if (!(feed > 1)) return {.kind = Kind::pushedBack};
    if (feed >= restingFeed(cor)) return {.kind = Kind::resting, .stable = true};
    const double velocity = feed / (1 + cor);              // (T36)
    const double delay = cor * velocity - (feed - 1) / 2;  // (T36)
    return {.kind = Kind::bouncing,
            .impactVelocity = velocity,
            .delay = delay,
            .gap = velocity * delay - (feed - 1) * delay * delay / 2,  // (T36)
            .stable = cor < 1};
}

double restingFeed(double cor) {
    return cor < 1 ? (1 + cor) / (1 - cor) : std::numeric_limits<double>::infinity();
}

std::string_view name(FeedState state) {
    static constexpr EnumNames<FeedState> names{{{FeedState::pushedBack, "pushed_back"},
                                                 {FeedState::belowRequired, "below_required"},
                                                 {FeedState::requiredAtThisGap, "required_at_this_gap"},
                                                 {FeedState::requiredMet, "required_met"},
                                                 {FeedState::returnMet, "return_met"},
                                                 {FeedState::notApplicable, "not_applicable"}}};
    return names[state];
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
    found.inD0 =
        gapPeriod(scenario) ? found.motion.gap * found.roundTrips : found.gap / scales.penetration;  // (T37)
    return found;
}

const ThrustNeed& largestOf(const ThrustNeeds& needs) {
    return *std::ranges::max_element(needs, {},
                                     [](const ThrustNeed& need) { return need.known ? need.thrust : -1; });
}

ThrustCase FeedEstimate::largestCase() const {
    return thrustCases[static_cast<std::size_t>(&largest() - needs.data())];
}

bool FeedEstimate::isOfAllGaps() const {
    return std::ranges::all_of(needs, &ThrustNeed::known);
}

std::optional<double> FeedEstimate::effective() const {
    return force ? std::optional(force->effective()) : std::nullopt;
}

std::optional<double> FeedEstimate::margin() const {
    return isOfAllGaps() ? largest().margin : std::nullopt;
}

std::optional<FeedState> FeedEstimate::state() const {
    if (roundTrips < 1) return FeedState::notApplicable;
    const std::optional<double> installed = effective();
    if (!installed) return std::nullopt;
    const auto isBelow = [&](double needed) { return *installed < (1 - rounding) * needed; };
    if (isBelow(balance)) return FeedState::pushedBack;
    if (isBelow(need(ThrustCase::scenario).thrust)) return FeedState::belowRequired;
    if (isBelow(largest().thrust)) return FeedState::requiredAtThisGap;
    return isBelow(largest().thrustUndamped) ? FeedState::requiredMet : FeedState::returnMet;
}

bool FeedEstimate::isTooLittle() const {
    const std::optional<FeedState> found = state();
    return found == FeedState::pushedBack || found == FeedState::belowRequired;
}

double FeedEstimate::thrustFor(double needed) const {
    return std::max(needed - weight, 0.0);
}

double FeedEstimate::frequencyFor(double needed) const {
    return force && needed > 0 ? frequency * std::max(force->effective(), 0.0) / needed : 0;
}

std::optional<FeedEstimate> feedEstimate(const Scenario& scenario, const Estimate& cor, double transferred,
                                         const std::optional<ReboundsOverGaps>& overGaps) {
    const std::optional<double> balance = thrustNeeded(scenario, 0, transferred);
    if (!balance) return std::nullopt;
    const auto needOrUnknown = [&](const std::optional<Estimate>& known) {
        if (known) return needOf(scenario, *known, transferred);
        ThrustNeed unknown;
        unknown.known = false;
        return unknown;
    };
    const auto ofGaps = [&](Estimate ReboundsOverGaps::*which) {
        return needOrUnknown(overGaps ? std::optional((*overGaps).*which) : std::nullopt);
    };
    FeedEstimate estimate;
    estimate.force = feedForceOf(scenario);
    estimate.weight = weightAlongHole(scenario).value_or(0);
    estimate.frequency = *scenario.drill.blowFrequency;
    estimate.balance = *balance;
    estimate.roundTrips = *roundTripsBetweenBlows(scenario);
    estimate.gapsHavePeriod = gapPeriod(scenario).has_value();
    estimate.needs = {needOrUnknown(cor), ofGaps(&ReboundsOverGaps::quantile), needOrUnknown(Estimate{1, 0}),
                      ofGaps(&ReboundsOverGaps::worst)};
    return estimate;
}

}  // namespace drillwave
