// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps at which a result turns by an angle.
#pragma once

#include <vector>

#include "core/study/gap/gap_curve.h"

namespace drillwave {

/// A gap at which e turns by an angle: slopes per d0 on both sides.
struct GapKink {
    double gap = 0;
    double cor = 0;
    double slopeBefore = 0;
    double slopeAfter = 0;
    int contactsBefore = 0;
    int contactsAfter = 0;
};

/// Returns the kinks of one period, ascending; one at its beginning is given at its end.
std::vector<GapKink> kinksOf(const GapCurve& curve);

/// Returns whether the slope of an output, whose values are of the size `scale`, jumps at a gap of the
/// period, clearly more than by the errors of the curve.
bool isKink(const GapCurve& curve, GapOutput output, double gap, double scale);

}  // namespace drillwave
