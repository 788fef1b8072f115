// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of energy and stresses in the sections of hammer and string, for people.
#pragma once

#include <string>

#include "core/blow/blow.h"
#include "core/report/report_text.h"

namespace drillwave {

/// Returns a table of how the hammer energy was distributed, as shares and in joules. Empty for a uniform
/// rod.
TextGrid energyGrid(const Blow& blow, const ReadingStyle& style = plainStyle());

/// Returns a table with headings and one line per section of hammer and string. A line has the largest
/// stresses with position and time. For sections of the string, it also has the share of the hammer energy
/// that the joint to the next section reflects. Where sections have strengths, the stresses are also given in
/// per cent of them. Requires a blow with the forces in its sections.
TextGrid sectionGrid(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
