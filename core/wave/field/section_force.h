// SPDX-License-Identifier: GPL-3.0-or-later
// The normal force at a section over time, and the waves that make it.
#pragma once

#include <span>

#include "core/wave/field/wave_curves.h"

namespace drillwave {

// Everything here needs an impact solved with Detail::histories. Times are global, in t0, forces in F0,
// tension positive, impulses in I0. ξ = x/L: rear end 0, bit 1.

/// What a strain gauge at a section would see, and the waves behind the first ones.
struct SectionForce {
    SampledCurve force;    ///< N = Np + Nn (T2), from time 0 or from the first wave there, if that is earlier
    SampledCurve toBit;    ///< waves N4p, N6p …, where four waves are known, one after the other
    SampledCurve fromBit;  ///< waves N5n, N7n …
};

/// At the section ξ until the time `end` (or until half a million points are told); `first` are
/// sectionWaves() there, an even number of them, that end before.
SectionForce sectionForce(const Impact& impact, double xi, std::span<const SectionWave> first, double end);

/// ∫N dt at the section up to t from some fixed time on.
double sectionImpulse(const Impact& impact, double xi, double t);

}  // namespace drillwave
