// SPDX-License-Identifier: GPL-3.0-or-later
// Means of a sequence of blows by which the feed force is judged: penetration, penetration rate, contact
// share and gap.
#pragma once

#include <optional>
#include <string_view>

#include "core/model/scenario.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Mean over the counted blows, with its 95 % error. The error includes the scatter of the blows and the
/// effect of the time step (cell). There is no error if only one blow is counted.
struct SequenceMean {
    double value = 0;
    std::optional<double> error;
};

/// Reason why the error of the mean penetration is too large to compare feed forces by it.
enum class UnresolvedReason { noWaveLoss, irregular, fewBlows, lengthsRounded };
/// Returns the name as in JSON: "no_wave_loss", "irregular", "few_blows" or "lengths_rounded".
std::string_view name(UnresolvedReason reason);

/// Model of the feed that presses the machine against the rod: a constant force, or a damper between the rod
/// and the mass of the machine.
enum class FeedModel { constantForce, damper };
/// Returns the name as in JSON: "constant_force" or "damper".
std::string_view name(FeedModel model);
/// Returns the feed model of a scenario: a damper if the scenario has a machine mass and a damper, otherwise
/// a constant force.
FeedModel feedModelOf(const Scenario& scenario);

/// Means of a sequence of blows by which feed forces are compared, in SI units.
struct Sequence {
    SequenceMean penetration;      ///< mean penetration per blow [m]
    SequenceMean penetrationRate;  ///< mean penetration rate [m/s]
    /// Mean penetration per blow divided by the penetration of a single blow from rest without a gap. Empty
    /// if the penetration of the single blow is not known.
    std::optional<SequenceMean> singleBlowShare;
    double contactShare = 0;  ///< share of blows that start within contactLimit of the rock, 0 … 1
    BlowSpread gap;           ///< statistics of the gap at the start of a blow [m]
    std::optional<UnresolvedReason> unresolved;

    bool isResolved() const { return !unresolved; }
};

/// Returns the means of the result of a sequence of blows, in SI units; empty if the result has no
/// statistics.
std::optional<Sequence> sequenceOf(const DrillingResult& result);

/// Wave loss suggested to the user if none is known: share of the amplitude that a wave loses per round trip.
/// Typical values are 0.01 … 0.3.
inline constexpr double usualWaveLoss = 0.1;

/// Maximum relative error with which a mean penetration is still precise enough to compare feed forces by it.
inline constexpr double resolvedShare = 0.05;

}  // namespace drillwave
