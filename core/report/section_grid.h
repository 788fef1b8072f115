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
/// stresses, their position and time, and the share of the hammer energy reflected by the joint at its far
/// end. If sections have strengths, stresses are also given as shares of them. Requires a blow with the
/// forces in its sections.
TextGrid sectionGrid(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
