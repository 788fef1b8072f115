// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths of sections in common steps, so that few cells make up a string and its waves can be kept.
#pragma once

#include "core/model/drill_string.h"

namespace drillwave {

/// Returns the nearest multiple of 10 mm of a length [m] from 50 mm on, of 5 mm from 20 mm on, and of 1 mm
/// below.
double roundedLength(double length);

/// Returns the hammer and string with the rounded lengths of all sections. A changed section is from no
/// preset.
DrillString withRoundedLengths(DrillString drillString);

}  // namespace drillwave
