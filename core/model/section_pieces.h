// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of sections: their shape in numbers and words, and the uniform pieces that stand for it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/drill_string.h"
#include "core/text/message.h"

namespace drillwave {

bool isUniform(const Section& section);
/// Returns whether all sections of hammer and string are uniform.
bool hasUniformSections(const DrillString& drillString);

/// Returns the cross-section [m²] at `share` of the length, 0 at the rear end … 1. In a cone the diameter is
/// linear and the bore constant; if it is given by areas, the diameter of a full bar is linear.
double areaAt(const Section& section, double share);

/// Returns the outer diameter [m] there; of a full bar for a section given by its area.
double outerDiameterAt(const Section& section, double share);

/// The larger one of its ends.
double largestDiameter(const Section& section);

/// Returns the mean of areaAt() between two shares [m²]: a uniform piece of that area has the same mass.
double meanArea(const Section& section, double from = 0, double to = 1);

/// Key of the size of its far end: "end_diameter".
std::string_view endKey(const Section& section);

/// Contradiction between sizes that are each in their range.
struct ShapeProblem {
    std::string_view field;  ///< key of one of them
    Message reason;          ///< "must be less than the diameter of 39 mm"
};
/// Returns all contradictions.
std::vector<ShapeProblem> shapeProblems(const Section& section);

/// "3660 mm × 39 mm … 45 mm / 14 mm": length, sizes from the rear end to the far one, and bore.
std::string sizeText(const Section& section);

/// Divides a section into `count` > 0 uniform pieces of equal length with the same total mass. The lumped
/// mass and the joint of the section are after the last piece. A uniform section in one piece is returned
/// unchanged. Waves in the pieces differ from those in a cone by the square of their lengths.
///
/// A joint with losses before it (`behindLoss`) reflects a wave before it weakens it, so that a step half a
/// piece later is not the same as one at the joint: the first of four or more pieces then has the
/// cross-section of the rear end, and the second one the mass that this leaves out.
std::vector<Section> uniformPieces(const Section& section, int count, bool behindLoss = false);

}  // namespace drillwave
