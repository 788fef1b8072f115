// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of studies by the time of a blow: followed by events it takes microseconds, on cells milliseconds.
#pragma once

#include <cstdint>
#include <optional>

#include "core/model/scenario.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

/// Points of a curve that is sampled.
inline constexpr std::uint64_t sampledPoints = 101;

/// Sizes of the studies of a scenario where none are asked for: those of blows followed by events.
struct StudyPlan {
    long workLimit = defaultWorkLimit;  ///< of a blow [wave pieces]
    int designSamples = 4096;           ///< of uncertain inputs
    int firstSamples = 256;             ///< of the first answer about a design
    std::optional<double> unasked;  ///< seconds that a study of designs takes unasked; empty: all it needs
    int mapPoints = 200;            ///< each way
    /// At which a curve of the window is sampled; empty: it is followed.
    std::optional<std::uint64_t> curvePoints;
    long curvePart = 6;  ///< of the work limit of a blow at the places of a followed curve: limit over this
    /// Blows of a piece of a followed curve, in blows at the work limit; empty: the work of all pieces is
    /// limited.
    std::optional<long> blowsOfPiece;
    /// Seconds that a comparison of methods takes; empty: it depends on the string.
    std::optional<int> accuracySeconds = 10;
};
StudyPlan studyPlan(const Scenario& scenario);

}  // namespace drillwave
