// SPDX-License-Identifier: GPL-3.0-or-later
// Default sizes of studies, which depend on the time of a blow: microseconds if it is solved by events,
// milliseconds on cells.
#pragma once

#include <cstdint>
#include <optional>

#include "core/model/scenario.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

/// Default number of points of a curve that is solved only at points and not fitted.
inline constexpr std::uint64_t sampledPoints = 101;

/// Default sizes of the studies of a scenario. The member defaults are for uniform rods, whose blows are
/// solved exactly from one contact event to the next.
struct StudyPlan {
    long workLimit = defaultWorkLimit;  ///< work limit of one blow [wave pieces]
    int designSamples = 4096;           ///< number of samples of uncertain inputs for each design
    int firstSamples = 256;             ///< number of samples for the first, quick result of a design
    /// Time limit [s] of a design study that the program window starts automatically, without a request of
    /// the user; empty for no limit.
    std::optional<double> unasked;
    int mapPoints = 200;  ///< number of points of a map along each axis
    /// Default number of points of a curve in the program window. If empty, the curve is not computed at
    /// given points but fitted to a tolerance.
    std::optional<std::uint64_t> curvePoints;
    long curvePart = 6;  ///< divisor of the work limit for blows at single points of a fitted curve
    /// Budget of blows for fitting a curve in one cell, which is one part of the parameter range. The number
    /// is for blows that need the whole work limit; cheaper blows may be more. If empty, only the total work
    /// of a cell is limited.
    std::optional<long> blowsOfPiece;
    /// Estimated time of a comparison of solution methods [s]; empty if it depends on the drill string.
    std::optional<int> accuracySeconds = 10;
};
/// Returns the default sizes of studies for a scenario, such as numbers of points and samples. They are
/// smaller for drill strings, whose blows take milliseconds instead of microseconds.
StudyPlan studyPlan(const Scenario& scenario);

}  // namespace drillwave
