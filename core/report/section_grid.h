// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and stresses of the sections of hammer and string, for people.
#pragma once

#include <string>

#include "core/blow/blow.h"
#include "core/report/report_text.h"

namespace drillwave {

/// Where the energy of the hammer went, in shares and in J. Empty for a uniform rod.
TextGrid energyGrid(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns titles, then for every section its largest stresses with place and time, as shares of its
/// strengths if sections have them, and the share reflected by the joint at its far end. Requires the forces.
TextGrid sectionGrid(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
