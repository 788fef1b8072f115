// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates of the required feed force from a single blow. The texts for them are in report/feed_words.h.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/model/scenario.h"
#include "core/numeric/estimate.h"
#include "core/text/enum_names.h"
#include "core/text/message.h"

namespace drillwave {

// Cases for which the required feed force is estimated

/// Cases of rock and gap for which the required feed force is estimated, from the blow of the scenario to the
/// worst blow.
enum class ThrustCase {
    /// Blow as the scenario describes it, with the gap between bit and rock of the scenario.
    scenario,
    /// All gaps between bit and rock within one period of the coefficient of restitution, with the rock of
    /// the scenario. The required feed force is sufficient for 95 % of them.
    gapQuantile,
    /// Rigid rock, with the coefficient of restitution e = 1; this case is the usual estimate of the required
    /// feed force.
    rigidRock,
    /// Elastic rock (γ = 1) of the same stiffness, with the gap that requires the largest feed force.
    elasticWorst,
};
inline constexpr auto thrustCases = allValues<ThrustCase>;
inline constexpr std::size_t thrustCaseCount = valueCount<ThrustCase>;

/// Returns the name of a case in files: "scenario", "gap_95_percent", "rigid_rock" or "elastic_worst_gap".
constexpr std::string_view name(ThrustCase which) {
    constexpr EnumNames<ThrustCase> names{{{ThrustCase::scenario, "scenario"},
                                           {ThrustCase::gapQuantile, "gap_95_percent"},
                                           {ThrustCase::rigidRock, "rigid_rock"},
                                           {ThrustCase::elasticWorst, "elastic_worst_gap"}}};
    return names[which];
}

// Force that presses machine and rod to the rock

/// Effective feed force Fe of theory §10 and its parts. Friction of the feed is neglected.
struct FeedForce {
    /// Installed feed force, in N.
    double thrust = 0;
    /// Weight along the hole, (machine mass + rod mass) g sin(inclination), in N, positive if it pulls
    /// towards the rock. Nothing if no inclination is given.
    std::optional<double> weight;
    bool operator==(const FeedForce&) const = default;

    /// Returns the effective feed force Fe, in N: installed feed force plus weight along the hole.
    double effective() const { return thrust + weight.value_or(0); }
    /// Returns Fe/needed − 1, the relative excess over a required feed force `needed` in N.
    double marginOver(double needed) const { return effective() / needed - 1; }
};

/// Returns the feed force of a scenario; nullopt if no installed feed force is given.
std::optional<FeedForce> feedForceOf(const Scenario& scenario);

/// Returns the weight along the hole, (machine mass + rod mass) g sin(inclination), in N. Returns nullopt
/// without units or an inclination. A missing machine mass counts as 0.
std::optional<double> weightAlongHole(const Scenario& scenario);

// Feed force that a single blow requires

/// Returns the required feed force f·I0·(1 + e), in N (T34) [paper (9)]. It is the mean force of the rock if
/// every blow starts at rest on the rock; a negative e = `cor` counts as 0. For drill strings (strings §7),
/// I0 is the impulse that the hammer transfers: its momentum times `transferred`
/// (ImpactSummary::transferred). Returns nullopt if thrustProblem() gives a reason.
std::optional<double> thrustNeeded(const Scenario& scenario, double cor, double transferred = 1);

/// Returns the reason why the required feed force cannot be computed for a scenario, and the remedy. Empty if
/// it can.
Message thrustProblem(const Scenario& scenario);

/// Returns the reason why the margin of the feed force (its excess over the required one) cannot be computed
/// for a scenario, and the remedy. Empty if it can.
Message thrustMarginProblem(const Scenario& scenario);

/// Returns the reason why a scenario has no blow frequency; empty if it has one. `what` names the quantity
/// that needs the frequency, such as "the feed force".
Message frequencyProblem(const Scenario& scenario, const char* what);

// Motion of a rod between blows if its rebound is not damped

/// Steady motion of a rigid rod that is struck f times per second, is pressed by a constant force Fe and
/// rebounds with the coefficient of restitution e (theory §10). φ = Fe/(f I0) is the ratio of that force to
/// the mean force of the blows.
struct UndampedMotion {
    /// Kind of steady motion, by the force ratio φ = Fe/(f I0) and the coefficient of restitution e.
    enum class Kind {
        /// Feed force ratio φ = Fe/(f I0) ≤ 1: the blows push the machine back, and there is no steady
        /// motion.
        pushedBack,
        /// Feed force ratio 1 < φ < (1+e)/(1−e), φ = Fe/(f I0): one impact on the rock per blow, and the bit
        /// is off the rock when the hammer strikes.
        bouncing,
        /// Feed force ratio φ = Fe/(f I0) ≥ (1+e)/(1−e): the rod is at rest on the rock before every blow.
        resting,
    };
    Kind kind = Kind::pushedBack;
    /// Impact velocity V on the rock, in units of v0 (T36); only for Kind::bouncing.
    double impactVelocity = 0;
    /// Time a from a blow to the impact of the bit on the rock, in units of the blow period 1/f (T36); only
    /// for Kind::bouncing.
    double delay = 0;
    /// Gap y between bit and rock when the hammer strikes, in units of v0/f (T36); ≥ 0.
    double gap = 0;
    /// Whether this steady motion is stable: after a small disturbance, the rod returns to it. False if the
    /// rod bounces with a coefficient of restitution e ≥ 1, or if the machine is pushed back.
    bool stable = false;
    bool operator==(const UndampedMotion&) const = default;
};

/// Returns the steady motion for φ = Fe/(f I0) = `feed` and the coefficient of restitution e = `cor` ≥ 0.
UndampedMotion undampedMotion(double feed, double cor);

/// Returns the smallest feed force ratio φ = Fe/(f I0) at which the rod rests on the rock before every blow:
/// (1+e)/(1−e), with e = `cor`. Infinite for e ≥ 1.
double restingFeed(double cor);

/// Gap between bit and rock when the hammer strikes, if nothing damps the rebound.
struct GapAtBlow {
    /// Steady motion of the rod at the effective feed force if nothing damps its rebound.
    UndampedMotion motion;
    /// Ratio φ = Fe/(f I0) of the effective feed force to the mean force of the blows.
    double feed = 0;
    /// Number n_b = 1/(2 T f) of round trips of a wave between two blows. T is the transit time of the rod, f
    /// the blow frequency.
    double roundTrips = 0;
    /// Gap between bit and rock when the hammer strikes, in m; 0 unless the rod bounces. It is y v0/f with
    /// the dimensionless gap y (T37).
    double gap = 0;
    /// Gap between bit and rock when the hammer strikes, in units of d0 = 2 I0/Z. For a uniform rod it is y
    /// n_b, with the gap y in v0/f and n_b = `roundTrips`.
    double inD0 = 0;
    bool operator==(const GapAtBlow&) const = default;
};

/// Returns the gap between bit and rock when the hammer strikes, if the rod rebounds undamped with the
/// coefficient of restitution `cor`. A drill string counts as a rigid body; `transferred` is the share of the
/// hammer's momentum that it receives. Returns nullopt without an installed feed force, or if thrustProblem()
/// gives a reason.
std::optional<GapAtBlow> gapAtBlow(const Scenario& scenario, double cor, double transferred = 1);

/// Required feed force of one case, computed with the coefficient of restitution e of that case. The members
/// `margin` and `frequencyLimit` refer to the member `thrust`.
struct ThrustNeed {
    /// Whether this case was computed; if not, the other members are meaningless. The two cases over all gaps
    /// need ReboundsOverGaps, which are not computed for drill strings.
    bool known = true;
    /// Coefficient of restitution e for the rock and gap of this case, with its error.
    Estimate cor;
    /// Required feed force f I0 (1+e), in N: the mean force that balances blows which start at rest on the
    /// rock.
    double thrust = 0;
    /// Feed force f I0 (1+2e), in N, with which an undamped rigid rod returns to the rock before the next
    /// blow.
    double thrustUndamped = 0;
    /// Margin of the feed force, (effective feed force)/`thrust` − 1; nullopt without an installed feed
    /// force.
    std::optional<double> margin;
    /// Largest blow frequency, in Hz, at which the effective feed force is still sufficient; the required
    /// force `thrust` grows in proportion to the frequency. Nullopt without an installed feed force.
    std::optional<double> frequencyLimit;
    /// Gap between bit and rock when the hammer strikes, computed with the effective feed force and the
    /// coefficient of restitution `cor`. Empty if no installed feed force is given.
    std::optional<GapAtBlow> gapAtBlow;
    bool operator==(const ThrustNeed&) const = default;
};

/// Required feed forces of all cases, in the order of ThrustCase.
using ThrustNeeds = std::array<ThrustNeed, thrustCaseCount>;

/// Returns the computed case with the largest required feed force `thrust`.
const ThrustNeed& largestOf(const ThrustNeeds& needs);

/// Rating of the effective feed force by the estimates from a single blow.
enum class FeedState {
    /// Effective feed force below f I0, the mean force of the blows: the machine is pushed back.
    pushedBack,
    /// Effective feed force at least the mean force of the blows, but below the required feed force of the
    /// blow of the scenario.
    belowRequired,
    /// Effective feed force sufficient for the blow of the scenario, but not for the largest required feed
    /// force of all computed cases (see ThrustCase).
    requiredAtThisGap,
    /// Effective feed force at least the largest required feed force of all computed cases (see ThrustCase).
    /// The rod may still be off the rock at the next blow.
    requiredMet,
    /// Effective feed force sufficient for all computed cases (see ThrustCase), and for the return of the rod
    /// to the rock before the next blow.
    returnMet,
    /// No rating, because waves of a blow are still present at the next one (n_b < 1).
    notApplicable,
};

/// Returns the name of a rating in files: "pushed_back", "below_required", "required_at_this_gap",
/// "required_met", "return_met" or "not_applicable".
std::string_view name(FeedState state);

/// Estimates of the required feed force for a scenario with units and a blow frequency.
struct FeedEstimate {
    /// Installed feed force and weight of the scenario; empty if no installed feed force is given.
    std::optional<FeedForce> force;
    /// Weight along the hole, in N, positive towards the rock; 0 if no inclination is given.
    double weight = 0;
    /// Blow frequency f, in Hz.
    double frequency = 0;
    /// Mean force of the blows f I0, in N.
    double balance = 0;
    /// Number n_b of round trips of a wave between two blows.
    double roundTrips = 0;
    /// Whether the coefficient of restitution repeats periodically as the gap between bit and rock grows, as
    /// for a uniform rod. Then the cases over all gaps can be computed.
    bool gapsHavePeriod = true;
    /// Required feed forces of all cases. The forces for the blow of the scenario and for rigid rock are
    /// always computed.
    ThrustNeeds needs;

    /// Returns the required feed force of one case.
    const ThrustNeed& need(ThrustCase which) const { return needs[static_cast<std::size_t>(which)]; }
    /// Returns the computed case with the largest required feed force `thrust`.
    const ThrustNeed& largest() const { return largestOf(needs); }
    /// Returns which computed case has the largest required feed force `thrust`.
    ThrustCase largestCase() const;
    /// Returns whether all four required feed forces are computed, including the two cases over all gaps
    /// between bit and rock.
    bool isOfAllGaps() const;
    /// Returns the effective feed force Fe, in N; nothing if no installed feed force is given.
    std::optional<double> effective() const;
    /// Returns the margin Fe/(largest required feed force of the four cases) − 1, with the effective feed
    /// force Fe. Nullopt if a case is not computed or no installed feed force is given.
    std::optional<double> margin() const;
    /// Returns the rating of the effective feed force. It is `notApplicable` if n_b < 1, as the waves of one
    /// blow then last until the next. Otherwise it is nullopt if no installed feed force is given.
    std::optional<FeedState> state() const;
    /// Returns whether the installed feed force is too small, so that a warning is due. The machine is then
    /// pushed back, or the force is below the required one of the blow of the scenario.
    bool isTooLittle() const;
    /// Returns the feed force to install, in N, so that feed and weight along the hole together give the
    /// required feed force `needed`; ≥ 0.
    double thrustFor(double needed) const;
    /// Returns the largest blow frequency, in Hz, for which the effective feed force is sufficient. `needed`
    /// is the required feed force at the present frequency, in N; it grows in proportion to the frequency.
    /// Returns 0 if no feed force is given, or if it does not press towards the rock.
    double frequencyFor(double needed) const;
    bool operator==(const FeedEstimate&) const = default;
};

/// Two coefficients of restitution e that summarise all gaps between bit and rock, for a uniform rod. e
/// repeats when the gap grows by one period, so one period covers all gaps.
struct ReboundsOverGaps {
    /// 95 % quantile of the coefficient of restitution over all gaps between bit and rock, on the rock of the
    /// scenario.
    Estimate quantile;
    /// Largest coefficient of restitution over all gaps between bit and rock, on elastic rock (γ = 1).
    Estimate worst;
};

/// Returns the required feed forces that follow from the coefficient of restitution `cor` of a blow.
/// `transferred` is the share of the hammer's momentum that a drill string receives. If `overGaps` is given,
/// the cases over all gaps between bit and rock are included. Returns nullopt if thrustProblem() gives a
/// reason.
std::optional<FeedEstimate> feedEstimate(const Scenario& scenario, const Estimate& cor,
                                         double transferred = 1,
                                         const std::optional<ReboundsOverGaps>& overGaps = {});

}  // namespace drillwave
