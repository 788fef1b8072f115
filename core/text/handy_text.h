// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people read them, rounded and in a unit that fits: never for files that are read back.
#pragma once

#include <string>

#include "core/text/number_text.h"
#include "core/text/units.h"

namespace drillwave {

/// An SI value in the unit of its customary family that needs the fewest zeros: "71.7 kN", "3.2 mm",
/// "105 MN/m"; a ratio as the bare number.
std::string inHandyUnit(double si, Quantity quantity, int digits = 6);

}  // namespace drillwave
