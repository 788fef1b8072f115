// SPDX-License-Identifier: GPL-3.0-or-later
// One function of a piecewise fit, cut where it turns: on each segment every value is taken once.
#pragma once

#include <span>
#include <vector>

#include "core/numeric/piecewise_fit.h"

namespace drillwave {

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
    /// Where a value from lower() to upper() is taken.
    double placeOf(double wanted) const;
};

/// Ascending; places without an answer are left out. The pieces must outlive the segments.
std::vector<MonotoneSegment> segmentsOf(std::span<const FitPiece> pieces, std::size_t output);

}  // namespace drillwave
