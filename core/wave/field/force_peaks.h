// SPDX-License-Identifier: GPL-3.0-or-later
// How often the impact force rises to a peak.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Number of peaks of F above 1 % of the largest force, of an impact solved with Detail::histories. Every
/// maximum inside a smooth piece is found; two that are parted by less than 1e-9 of the largest force, which
/// rounding could do, are one.
int forcePeaks(const Impact& impact);

}  // namespace drillwave
