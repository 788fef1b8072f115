// SPDX-License-Identifier: GPL-3.0-or-later
// In which unit an output is shown.
#pragma once

#include "core/blow/outputs.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Of an output's values in its measure (Output::measure). Plain numbers, works and shares, which are plain
/// in SI too, have none. `size` is that of the values where there is no dimensionless number: N, W or m/s.
ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size);

}  // namespace drillwave
