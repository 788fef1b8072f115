// SPDX-License-Identifier: GPL-3.0-or-later
// The curve of one output over the gap, cut where it turns: on each segment every value is taken once.
#pragma once

#include <vector>

#include "core/study/gap/gap_curve.h"

namespace drillwave {

/// A stretch of gap over which an output only rises or only falls.
struct GapSegment {
    double start = 0;
    double end = 0;
    double first = 0;  ///< value at start
    double last = 0;   ///< value at end
    const GapPiece* piece = nullptr;
    std::size_t output = 0;

    double value(double gap) const { return piece->outputs[output](gap); }
    double error() const { return piece->error[output]; }
    double lower() const { return first < last ? first : last; }
    double upper() const { return first < last ? last : first; }
    /// Where a value from lower() to upper() is taken.
    double gapOf(double value) const;
};

/// Ascending; gaps without an answer are left out. The curve must outlive the segments.
std::vector<GapSegment> segmentsOf(const GapCurve& curve, GapOutput output);

}  // namespace drillwave
