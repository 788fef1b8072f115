// SPDX-License-Identifier: GPL-3.0-or-later
// Means of a sequence of blows by which the feed is judged: penetration and rate with their errors, contact,
// gap.
#pragma once

#include <optional>
#include <string_view>

#include "core/model/scenario.h"
#include "core/study/drilling/drilling_study.h"

namespace drillwave {

/// Mean of the counted blows. The error, of 95 %, contains the scatter of the blows and the change by other
/// cells; a single blow has none.
struct SequenceMean {
    double value = 0;
    std::optional<double> error;
};

/// Reason why the mean penetration is not known well enough for a comparison.
enum class UnresolvedReason { noWaveLoss, irregular, fewBlows, lengthsRounded };
/// "no_wave_loss", "irregular", "few_blows", "lengths_rounded".
std::string_view name(UnresolvedReason reason);

/// Model of the feed between machine and rod.
enum class FeedModel { constantForce, damper };
/// "constant_force", "damper".
std::string_view name(FeedModel model);
/// A damper acts on the mass of a machine.
FeedModel feedModelOf(const Scenario& scenario);

/// Means of a result with statistics; SI.
struct Sequence {
    SequenceMean penetration;      ///< of a blow [m]
    SequenceMean penetrationRate;  ///< [m/s]
    /// Mean penetration over that of a single blow from rest without a gap, if that is known.
    std::optional<SequenceMean> singleBlowShare;
    double contactShare = 0;  ///< blows that start within contactLimit of the rock
    BlowSpread gap;           ///< [m]
    std::optional<UnresolvedReason> unresolved;

    bool isResolved() const { return !unresolved; }
};

/// Returns nothing without statistics.
std::optional<Sequence> sequenceOf(const DrillingResult& result);

/// A wave loss to begin with, where none is known: 1 to 30 % of a round trip is usual.
inline constexpr double usualWaveLoss = 0.1;

/// Errors of the mean penetration up to this share of it are resolved.
inline constexpr double resolvedShare = 0.05;

}  // namespace drillwave
