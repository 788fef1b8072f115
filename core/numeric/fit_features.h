// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes, kinks and crossings of a level of a function that is fitted piece by piece.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/numeric/piecewise_fit.h"

namespace drillwave {

// Fitted function, cut at its extremes, so that each segment takes every value only once.

/// Interval over which a fitted function only rises or only falls.
struct MonotoneSegment {
    double start = 0;
    double end = 0;
    double first = 0;  ///< value of the function at `start`
    double last = 0;   ///< value of the function at `end`
    const FitPiece* piece = nullptr;
    std::size_t output = 0;

    double value(double x) const { return piece->outputs[output](x); }
    double error() const { return piece->error[output]; }
    double lower() const { return first < last ? first : last; }
    double upper() const { return first < last ? last : first; }
    /// Returns the x in this segment at which the function has the value `wanted`. Requires lower() ≤ wanted
    /// ≤ upper().
    double placeOf(double wanted) const;
};

/// Returns the monotone segments of one fitted function (index `output`) in ascending order. Intervals in
/// which it has no values are left out. The segments point to the pieces, which must outlive them.
std::vector<MonotoneSegment> segmentsOf(std::span<const FitPiece> pieces, std::size_t output);

/// One side of a point where the slope of a fitted function may jump: the nearest piece with a reliable
/// slope, the slope at the end of that piece, and the error of the slope.
struct FitSide {
    const FitPiece* piece = nullptr;
    double slope = 0;
    double error = 0;
};

/// Smallest change of slope that counts as a kink, relative to the size of the values or to the steeper
/// slope, whichever is larger.
inline constexpr double leastAngle = 1e-3;
/// Length below which a piece has no reliable slope, in units of x. Kinks closer than this count as one.
inline constexpr double leastSlopeWidth = 1e-6;

/// Returns whether the slope in a piece can be trusted: the piece is longer than leastSlopeWidth, and its
/// error is within the tolerance of the fit.
bool hasSlope(const FitPiece& piece);

/// Returns the left and the right side of a point that may be a kink. `fromLeft` and `fromRight` are both
/// the x of this point; for a periodic function they may differ by the period. Returns nullopt if the point
/// is inside a piece, where the function is smooth. Also returns nullopt if there is no piece on one of the
/// two sides.
std::optional<std::pair<FitSide, FitSide>> sidesAt(std::span<const FitPiece> pieces, std::size_t output,
                                                   double fromLeft, double fromRight);

/// Returns whether the slope of a function clearly jumps from the left to the right side of a point. The
/// jump must exceed the errors of both slopes. The excess must be at least leastAngle times the steeper
/// slope, or times `scale` if that is larger. `scale` is the size of the function's values.
bool isAngle(const FitSide& left, const FitSide& right, double scale);

/// Least or largest value of a function, and the x at which it is taken.
struct FitExtreme {
    Estimate value;
    /// Position x of the extreme. Its error is the distance within which the value of the function changes by
    /// no more than the error of that value.
    Estimate place;
    bool everywhere = false;  ///< the function is constant within its errors
};

enum class Extreme { least, largest };

/// Returns the least or largest value of a function over all its segments. Requires at least one segment.
FitExtreme extremeOf(std::span<const MonotoneSegment> segments, Extreme which);

/// Local minimum or maximum of a function, which differs from the values on both sides by more than the
/// errors.
struct LocalExtreme {
    Extreme which = Extreme::least;
    Estimate value;
    /// Position x of the extreme. Its error is the distance within which the value of the function changes by
    /// no more than the error of that value.
    Estimate place;
};
/// Returns the local minima and maxima of a function in ascending order of x, without those at its two ends.
std::vector<LocalExtreme> localExtremesOf(std::span<const MonotoneSegment> segments);

/// Point at which a fitted function crosses a level, upwards if `rising`, otherwise downwards. On both sides
/// of the point, the function differs from the level by more than the error of the fit.
struct FitCrossing {
    Estimate place;
    bool rising = false;
};
/// Returns the points at which a function crosses `level`, in ascending order of x.
std::vector<FitCrossing> crossingsOf(std::span<const MonotoneSegment> segments, double level);

}  // namespace drillwave
