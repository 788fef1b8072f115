// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates of the required feed force from a single blow. Their words are in
// report/feed_words.h.
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

// What the thrust is wanted for.

/// From the case at hand to the worst.
enum class ThrustCase {
    scenario,      ///< the blow as given
    gapQuantile,   ///< 95 % of all gaps of a period, in this rock
    rigidRock,     ///< e = 1, the usual estimate
    elasticWorst,  ///< γ = 1 at this stiffness, the worst of all gaps
};
inline constexpr auto thrustCases = allValues<ThrustCase>;
inline constexpr std::size_t thrustCaseCount = valueCount<ThrustCase>;

/// "scenario", "gap_95_percent", "rigid_rock", "elastic_worst_gap".
constexpr std::string_view name(ThrustCase which) {
    constexpr EnumNames<ThrustCase> names{{{ThrustCase::scenario, "scenario"},
                                           {ThrustCase::gapQuantile, "gap_95_percent"},
                                           {ThrustCase::rigidRock, "rigid_rock"},
                                           {ThrustCase::elasticWorst, "elastic_worst_gap"}}};
    return names[which];
}

// The force that presses machine and rod to the rock.

/// The effective force F of theory §10 and its parts. Friction of the feed is not counted.
struct FeedForce {
    double thrust = 0;  ///< installed [N]
    /// (machine mass + rod mass) g sin(inclination) [N], positive where it pulls to the rock; nothing where
    /// no inclination is given.
    std::optional<double> weight;
    bool operator==(const FeedForce&) const = default;

    double effective() const { return thrust + weight.value_or(0); }  ///< F [N]
    /// How much more it is than a thrust that is needed [N], over that.
    double marginOver(double needed) const { return effective() / needed - 1; }
};

/// nullopt where no thrust is installed.
std::optional<FeedForce> feedForceOf(const Scenario& scenario);

/// (machine mass + rod mass) g sin(inclination) [N]; nullopt without units or an inclination. Without a
/// machine mass it is the weight of the rod alone.
std::optional<double> weightAlongHole(const Scenario& scenario);

// The feed force that blows need for full penetration.

/// Mean thrust f·I0·(1 + e) [N] (T34) [paper (9)]: the impulse that the rock gives back with every blow that
/// begins at rest on the rock. Of a drill string (strings §7) I0 is what its hammer hands on, `transferred`
/// of its momentum (ImpactSummary::transferred), and a string that still moves to the rock counts as e = 0.
/// nullopt where thrustProblem() says why.
std::optional<double> thrustNeeded(const Scenario& scenario, double cor, double transferred = 1);

/// Why there is no thrust for a scenario and what to do; empty when there is one.
Message thrustProblem(const Scenario& scenario);

/// Why there is no margin of the installed thrust, likewise.
Message thrustMarginProblem(const Scenario& scenario);

/// Why there is nothing per time for a scenario, `what` being "the feed force" or the like; empty when there
/// is.
Message frequencyProblem(const Scenario& scenario, const char* what);

// What a rod does between blows if nothing damps its rebound.

/// The steady motion of a rigid rod that is struck f times a second, is pressed by a constant force and
/// rebounds with e (theory §10).
struct UndampedMotion {
    enum class Kind {
        pushedBack,  ///< φ ≤ 1: the blows push the machine back, and no steady motion is left
        bouncing,  ///< 1 < φ < (1+e)/(1−e): one impact per blow, the bit off the rock when the hammer strikes
        resting,  ///< beyond: it has come to rest on the rock before every blow
    };
    Kind kind = Kind::pushedBack;
    double impactVelocity = 0;  ///< V [v0] (T36), of Kind::bouncing
    double delay = 0;           ///< a, from a blow to the impact [1/f] (T36), of Kind::bouncing
    double gap = 0;             ///< y ≥ 0, between bit and rock when the hammer strikes [v0/f] (T36)
    /// Whether the motion comes back to this one when it is disturbed: not where it bounces with e ≥ 1.
    bool stable = false;
    bool operator==(const UndampedMotion&) const = default;
};

/// For the feed φ = F/(f I0) and e ≥ 0.
UndampedMotion undampedMotion(double feed, double cor);

/// φ = (1+e)/(1−e), from which on the rod rests before every blow; infinite for e ≥ 1.
double restingFeed(double cor);

/// Where the bit is when the hammer strikes, if nothing damps the rebound.
struct GapAtBlow {
    UndampedMotion motion;
    double feed = 0;        ///< φ = F/(f I0)
    double roundTrips = 0;  ///< n_b = 1/(2 T f)
    double gap = 0;         ///< y v0/f [m] (T37), 0 but where it bounces
    double inD0 = 0;        ///< the same, y n_b of a uniform rod [d0]
    bool operator==(const GapAtBlow&) const = default;
};

/// nullopt without an installed thrust, or where thrustProblem() says why. A drill string moves as a rigid
/// body.
std::optional<GapAtBlow> gapAtBlow(const Scenario& scenario, double cor, double transferred = 1);

/// The required force of one case, by its own e. Margin and frequency limit are about `thrust`.
struct ThrustNeed {
    /// Whether it was computed. The gaps of a drill string have no period, so its cases of all gaps are not.
    bool known = true;
    Estimate cor;
    double thrust = 0;             ///< f I0 (1+e): the mean force that balances a blow from rest [N]
    double thrustUndamped = 0;     ///< f I0 (1+2e): an undamped rigid rod is back before the next blow [N]
    std::optional<double> margin;  ///< effective force over `thrust`, less 1, with an installed thrust
    /// Up to which blow frequency the effective force is at least `thrust` [Hz].
    std::optional<double> frequencyLimit;
    std::optional<GapAtBlow> gapAtBlow;  ///< at the effective force, by this e
    bool operator==(const ThrustNeed&) const = default;
};

/// In the order of ThrustCase.
using ThrustNeeds = std::array<ThrustNeed, thrustCaseCount>;

/// The one with the largest `thrust` of those that are known.
const ThrustNeed& largestOf(const ThrustNeeds& needs);

/// The effective feed force among the estimates of single blows.
enum class FeedState {
    pushedBack,         ///< below f I0: less than the mean force of the blows
    belowRequired,      ///< below what this blow requires
    requiredAtThisGap,  ///< this blow is covered, the largest examined case is not
    requiredMet,        ///< the largest examined case is covered
    returnMet,          ///< the same with return in time
    notApplicable,      ///< the waves of a blow are still there when the next one comes, n_b < 1
};

/// "pushed_back", "below_required", "required_at_this_gap", "required_met", "return_met", "not_applicable".
std::string_view name(FeedState state);

/// The estimates of a scenario with units and a blow frequency.
struct FeedEstimate {
    std::optional<FeedForce> force;  ///< nothing where no thrust is installed
    double weight = 0;               ///< along the hole, 0 where no inclination is given [N]
    double frequency = 0;            ///< of blows [Hz]
    double balance = 0;              ///< f I0 [N]
    double roundTrips = 0;           ///< n_b
    bool gapsHavePeriod = true;      ///< of a uniform rod: its cases of all gaps can be computed
    ThrustNeeds needs;               ///< this blow and rigid rock are always known

    const ThrustNeed& need(ThrustCase which) const { return needs[static_cast<std::size_t>(which)]; }
    /// The known case with the largest `thrust`.
    const ThrustNeed& largest() const { return largestOf(needs); }
    ThrustCase largestCase() const;
    /// Whether all four cases are known.
    bool isOfAllGaps() const;
    /// F [N], nothing where no thrust is installed.
    std::optional<double> effective() const;
    /// F over the largest of the four cases, less 1; nothing where one of them is not known.
    std::optional<double> margin() const;
    /// Nothing where no thrust is installed and the estimates apply.
    std::optional<FeedState> state() const;
    /// Whether a warning is due: the machine is pushed back, or the feed is below what this blow requires.
    bool isTooLittle() const;
    /// The thrust to install for such a need: what the weight along the hole does not bring [N], ≥ 0.
    double thrustFor(double needed) const;
    /// Up to which blow frequency what is installed covers such a need [Hz]; 0 where nothing presses to the
    /// rock.
    double frequencyFor(double needed) const;
    bool operator==(const FeedEstimate&) const = default;
};

/// COR e over all gaps.
struct ReboundsOverGaps {
    Estimate quantile;  ///< 95 % of all gaps of a period are at or below
    Estimate worst;     ///< of elastic rock
};

/// Estimates by the e of the blow itself; the hammer of a drill string transfers `transferred` of its
/// momentum. nullopt where thrustProblem() says why.
std::optional<FeedEstimate> feedEstimate(const Scenario& scenario, const Estimate& cor,
                                         double transferred = 1,
                                         const std::optional<ReboundsOverGaps>& overGaps = {});

}  // namespace drillwave
