// What feed force keeps the bit on the rock, and what the installed one means at the rig.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/model/scenario.h"
#include "core/study/gap_statistics.h"
#include "core/study/thrust.h"

namespace drillwave {

/// What the thrust is wanted for, from the case at hand to the worst.
enum class ThrustCase {
    scenario,      ///< the blow as given
    gapQuantile,   ///< 95 % of all gaps of a period, in this rock
    rigidRock,     ///< e = 1, the usual estimate
    elasticWorst,  ///< γ = 1 at this stiffness, the worst of all gaps
};
inline constexpr std::size_t thrustCaseCount = 4;

/// "scenario", "gap_95_percent", "rigid_rock", "elastic_worst_gap".
std::string_view name(ThrustCase which);

/// What one case needs.
struct ThrustNeed {
    Estimate cor;
    double thrust = 0;             ///< [N]
    std::optional<double> margin;  ///< installed/needed − 1, with an installed thrust
    /// Up to which blow frequency the installed thrust is enough [Hz].
    std::optional<double> frequencyLimit;
};

/// The installed thrust, judged.
enum class Feed {
    unknown,           ///< no thrust is given
    tooLow,            ///< less than this blow needs
    lowAtOtherGaps,    ///< enough for this blow, not for 95 % of all gaps
    lowOnElasticRock,  ///< enough for this rock, not for rock or cuttings that push the bit back
    enough,            ///< for all of them
    tooHigh,           ///< more than `overfeed` times what the worst of them needs
};

/// Thrust over the largest need from which on it is called over-feeding: a rule of thumb, no result of the
/// model.
inline constexpr double overfeed = 1.5;

/// "too_low" and so on.
std::string_view name(Feed feed);

struct ThrustStudy {
    std::array<ThrustNeed, thrustCaseCount> needs;  ///< in the order of ThrustCase
    std::optional<double> shareHeld;  ///< share of all gaps at which the installed thrust is enough
    Feed feed = Feed::unknown;
    std::string reason;    ///< why there is no result; empty when there is
    bool stopped = false;  ///< on the stop token: no result

    const ThrustNeed& need(ThrustCase which) const { return needs[static_cast<std::size_t>(which)]; }
    const ThrustNeed& largestNeed() const;
};

/// Requires thrustProblem() to be empty.
ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop = {},
                        const GapProgress& progress = {});

/// What the judgement means at the rig and what to do, in a sentence or two without numbers of the model.
std::string_view feedAdvice(Feed feed);

}  // namespace drillwave
