// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps at which the slope of a result jumps.
#pragma once

#include <vector>

#include "core/study/gap/gap_curve.h"

namespace drillwave {

/// Gap at which the slope of the coefficient of restitution e jumps. Slopes are per unit of δ = d/d0.
struct GapKink {
    double gap = 0;
    double cor = 0;
    double slopeBefore = 0;
    double slopeAfter = 0;
    int contactsBefore = 0;
    int contactsAfter = 0;
};

/// Returns the kinks of e in one period of the gap, ascending. A kink at the start of the period is the same
/// as one at its end, and is only listed there.
std::vector<GapKink> kinksOf(const GapCurve& curve);

/// Returns whether the curve of an output has a kink at a gap within the period: its slope jumps by clearly
/// more than the errors allow. `scale` is the typical size of the output, against which the jump is judged.
bool isKink(const GapCurve& curve, GapOutput output, double gap, double scale);

}  // namespace drillwave
