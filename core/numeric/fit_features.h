// SPDX-License-Identifier: GPL-3.0-or-later
// Where a piecewise fit is least and largest, turns by an angle, and crosses a level.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/numeric/estimate.h"
#include "core/numeric/piecewise_fit.h"

namespace drillwave {

// One function of a piecewise fit, cut where it turns: on each segment every value is taken once.

/// A stretch over which a function only rises or only falls.
struct MonotoneSegment {
    double start = 0;
    double end = 0;
    double first = 0;  ///< value at start
    double last = 0;   ///< value at end
    const FitPiece* piece = nullptr;
    std::size_t output = 0;

    double value(double x) const { return piece->outputs[output](x); }
    double error() const { return piece->error[output]; }
    double lower() const { return first < last ? first : last; }
    double upper() const { return first < last ? last : first; }
    /// Returns where a value from lower() to upper() is taken.
    double placeOf(double wanted) const;
};

/// Ascending; places without an answer are left out. The pieces must outlive the segments.
std::vector<MonotoneSegment> segmentsOf(std::span<const FitPiece> pieces, std::size_t output);

/// One side of a place where a function may turn: the nearest piece that has a slope, and that slope.
struct FitSide {
    const FitPiece* piece = nullptr;
    double slope = 0;
    double error = 0;
};

/// An angle that counts as a kink: change of slope, relative to the values or to the steeper side.
inline constexpr double leastAngle = 1e-3;
/// Shorter pieces are slivers around a kink; several kinks this close are one.
inline constexpr double leastSlopeWidth = 1e-6;

/// Whether a piece is more than a sliver, and has been resolved.
bool hasSlope(const FitPiece& piece);

/// The sides of a place that `fromLeft` and `fromRight` both name, where the function is periodic as
/// different numbers; nullopt inside a piece, where nothing turns, and where there is no other side.
std::optional<std::pair<FitSide, FitSide>> sidesAt(std::span<const FitPiece> pieces, std::size_t output,
                                                   double fromLeft, double fromRight);

/// Whether the slope of a function whose values are of the size `scale` jumps, clearly more than by the
/// errors of the fit.
bool isAngle(const FitSide& left, const FitSide& right, double scale);

/// The least or largest value, and a place where it is taken.
struct FitExtreme {
    Estimate value;
    Estimate place;           ///< its error is how far the value stays within its own error
    bool everywhere = false;  ///< the function is the same everywhere, within errors
};

enum class Extreme { least, largest };

/// Requires at least one segment.
FitExtreme extremeOf(std::span<const MonotoneSegment> segments, Extreme which);

/// The least and largest values of neighbourhoods, further from the values on both sides than by errors; not
/// those at the ends of where there are values. Ascending.
struct LocalExtreme {
    Extreme which = Extreme::least;
    Estimate value;
    Estimate place;  ///< as in FitExtreme
};
std::vector<LocalExtreme> localExtremesOf(std::span<const MonotoneSegment> segments);

/// A place where a function passes from clearly below a level to clearly above, or back.
struct FitCrossing {
    Estimate place;
    bool rising = false;
};
std::vector<FitCrossing> crossingsOf(std::span<const MonotoneSegment> segments, double level);

}  // namespace drillwave
