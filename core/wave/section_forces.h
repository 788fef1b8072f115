// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in one section of a hammer or a string.
#pragma once

#include "core/wave/loads.h"

namespace drillwave {

/// The largest force of one sign in a section, and where; in a cone that of the largest stress.
struct SectionPeak {
    double force = 0;  ///< [F0], of either sign ≥ 0
    double place = 0;  ///< ξ in the section, 0 at its rear end … 1
    double time = 0;   ///< [t0]
};

/// Compression and tension of one section of hammer or string, as RodForces has those of a rod: while the
/// blow lasts, to one transit of the string after the last separation of bit and rock, and later: at least
/// while waves run to and fro once in the string, unless an end time or the next blow come before.
using SectionForces = OfLoads<SectionPeak>;

}  // namespace drillwave
